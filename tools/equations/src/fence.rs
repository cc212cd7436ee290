//! Fenced code blocks, followed from line to line.

/// Distinguishes lines of fenced code from lines of prose.
#[derive(Default)]
pub struct Fences {
    open: Option<Fence>,
}

struct Fence {
    mark: char,
    length: usize,
}

impl Fences {
    /// Takes the next line and returns whether it is code or a fence around code.
    pub fn covers(&mut self, line: &str) -> bool {
        let line = line.trim_start_matches([' ', '\t', '>']);
        match &self.open {
            Some(fence) => {
                if fence.closed_by(line) {
                    self.open = None;
                }
                true
            }
            None => {
                self.open = Fence::opened_by(line);
                self.open.is_some()
            }
        }
    }
}

impl Fence {
    fn opened_by(line: &str) -> Option<Self> {
        let mark = line
            .chars()
            .next()
            .filter(|mark| matches!(mark, '`' | '~'))?;
        let info = line.trim_start_matches(mark);
        let length = line.len() - info.len();
        let inline_code = mark == '`' && info.contains(mark);
        (length >= 3 && !inline_code).then_some(Self { mark, length })
    }

    fn closed_by(&self, line: &str) -> bool {
        let rest = line.trim_start_matches(self.mark);
        line.len() - rest.len() >= self.length && rest.trim().is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::Fences;

    fn covered(lines: &[&str]) -> Vec<bool> {
        let mut fences = Fences::default();
        lines.iter().map(|line| fences.covers(line)).collect()
    }

    #[test]
    fn lines_between_fences_are_code() {
        let lines = [" a", " ```text", " b", " ```", " c"];
        assert_eq!(covered(&lines), [false, true, true, true, false]);
    }

    #[test]
    fn only_a_matching_fence_closes() {
        let lines = ["````", "```", "~~~~", "```` rust", "````", "a"];
        assert_eq!(covered(&lines), [true, true, true, true, true, false]);
    }

    #[test]
    fn code_within_a_sentence_opens_nothing() {
        assert_eq!(covered(&["```a``` b", "``", "c"]), [false, false, false]);
    }

    #[test]
    fn fences_in_lists_and_quotes_count() {
        assert_eq!(
            covered(&["     ~~~", "a", "     ~~~", "b"]),
            [true, true, true, false]
        );
        assert_eq!(
            covered(&["> ```", "> a", "> ```", "b"]),
            [true, true, true, false]
        );
    }
}
