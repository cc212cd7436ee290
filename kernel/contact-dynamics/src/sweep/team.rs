//! Threads that share jobs of some tasks each.
//!
//! The leader publishes a job, takes tasks itself as long as there are any, and waits only for tasks that another
//! thread has taken. Helpers may come late or never; they look for tasks until the leader dismisses them. Many short
//! jobs in a row cost little, because nobody falls asleep between them. The leader takes the first tasks and helpers
//! take the last ones, so that two threads mostly find the data of their tasks in their own caches.

use core::hint::spin_loop;
use core::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Rounds of waiting after which a thread lets others run.
const PATIENCE: usize = 20_000;

/// Largest number of tasks of a job.
const TASKS: u64 = u16::MAX as u64;

#[derive(Clone, Copy)]
enum Member {
    Leader,
    Helper,
}

/// A team without threads; the leader and its helpers call its methods.
#[derive(Debug)]
pub(super) struct Team<J> {
    job: Mutex<J>,
    /// Number of the job, and the first task that nobody has taken and the end of these tasks, 16 bits each.
    open: AtomicU64,
    finished: AtomicUsize,
    is_dismissed: AtomicBool,
}

impl<J: Copy> Team<J> {
    /// A team that has nothing to do.
    pub fn new(job: J) -> Self {
        Self {
            job: Mutex::new(job),
            open: AtomicU64::new(0),
            finished: AtomicUsize::new(0),
            is_dismissed: AtomicBool::new(false),
        }
    }

    /// Have a job done; for the leader.
    pub fn lead(&self, job: J, tasks: usize, work: impl Fn(J, usize)) {
        *lock(&self.job) = job;
        self.finished.store(0, Ordering::Relaxed);
        // Nobody takes tasks at this time, because there are none.
        let number = (self.open.load(Ordering::Relaxed) >> 32).wrapping_add(1);
        self.open
            .store(number << 32 | tasks as u64, Ordering::Release);
        while let Some(task) = self.take(Member::Leader) {
            work(job, task);
            self.finished.fetch_add(1, Ordering::Release);
        }
        let mut rounds = 0;
        while self.finished.load(Ordering::Acquire) < tasks {
            wait(&mut rounds);
        }
    }

    /// Take tasks until the team is dismissed; for helpers.
    pub fn help(&self, work: impl Fn(J, usize)) {
        let mut rounds = 0;
        while !self.is_dismissed.load(Ordering::Acquire) {
            if let Some(task) = self.take(Member::Helper) {
                // The job stays until all of its tasks are finished.
                let job = *lock(&self.job);
                work(job, task);
                self.finished.fetch_add(1, Ordering::Release);
                rounds = 0;
            } else {
                wait(&mut rounds);
            }
        }
    }

    /// Send the helpers away.
    pub fn dismiss(&self) {
        self.is_dismissed.store(true, Ordering::Release);
    }

    fn take(&self, member: Member) -> Option<usize> {
        let mut open = self.open.load(Ordering::Acquire);
        loop {
            let (first, end) = (open >> 16 & TASKS, open & TASKS);
            if first == end {
                return None;
            }
            let (task, rest) = match member {
                Member::Leader => (first, open + (1 << 16)),
                Member::Helper => (end - 1, open - 1),
            };
            let taken =
                self.open
                    .compare_exchange_weak(open, rest, Ordering::AcqRel, Ordering::Acquire);
            match taken {
                Ok(_) => return Some(task as usize),
                Err(now) => open = now,
            }
        }
    }
}

fn wait(rounds: &mut usize) {
    *rounds += 1;
    if rounds.is_multiple_of(PATIENCE) {
        std::thread::yield_now();
    } else {
        spin_loop();
    }
}

/// Lock data that no panic can leave in disorder.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
