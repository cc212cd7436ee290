//! Pairs of columns: the two components of vectors, or the values at the two ends of contacts and bonds.
//!
//! Kept as two separate columns, one vector instruction reads the values of several pairs.

use crate::parts::split_or_empty;
use core::ops::{Deref, DerefMut, Range};
use prefetch_index::prefetch_index;

/// The two values at an index.
#[inline(always)]
pub fn at<T: Copy, C: Deref<Target = [T]>>(columns: &[C; 2], position: usize) -> [T; 2] {
    [columns[0][position], columns[1][position]]
}

/// Prefetch the cache line of each column that holds an index.
#[inline(always)]
pub fn prefetch<T, C: Deref<Target = [T]>>(columns: &[C; 2], position: usize) {
    for column in columns {
        prefetch_index(&**column, position);
    }
}

/// Set the two values at an index.
#[inline(always)]
pub fn set<T, C: DerefMut<Target = [T]>>(
    columns: &mut [C; 2],
    position: usize,
    [first, second]: [T; 2],
) {
    columns[0][position] = first;
    columns[1][position] = second;
}

/// A range of both columns, mutable.
#[inline(always)]
pub fn range_mut<'a, T>(
    [first, second]: &'a mut [&mut [T]; 2],
    positions: Range<usize>,
) -> [&'a mut [T]; 2] {
    [&mut first[positions.clone()], &mut second[positions]]
}

/// Split both columns at an index.
pub fn split<T>(columns: [&[T]; 2], at: usize) -> ([&[T]; 2], [&[T]; 2]) {
    let [(first, other_first), (second, other_second)] = columns.map(|column| column.split_at(at));
    ([first, second], [other_first, other_second])
}

/// Split both mutable columns at an index; empty columns stay empty.
pub fn split_mut<T>([first, second]: [&mut [T]; 2], at: usize) -> ([&mut [T]; 2], [&mut [T]; 2]) {
    let (first, other_first) = split_or_empty(first, at);
    let (second, other_second) = split_or_empty(second, at);
    ([first, second], [other_first, other_second])
}

/// Both columns as slices.
#[inline(always)]
pub fn slices<T>([first, second]: &[Vec<T>; 2]) -> [&[T]; 2] {
    [first, second]
}

/// Both columns as mutable slices.
#[inline(always)]
pub fn slices_mut<T>([first, second]: &mut [Vec<T>; 2]) -> [&mut [T]; 2] {
    [first, second]
}

/// Collect two values per item into two columns.
pub fn collect<I, T: Copy>(items: &[I], of: impl Fn(&I) -> [T; 2]) -> [Vec<T>; 2] {
    [0, 1].map(|which| items.iter().map(|item| of(item)[which]).collect())
}
