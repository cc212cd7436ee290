//! Two columns side by side: the components of vectors, or what belongs to both ends of links.
//!
//! Apart they are read by one instruction for several links; as pairs of numbers they would first have to be
//! taken apart.

use crate::parts::halves;
use core::ops::{Deref, DerefMut, Range};
use prefetch_index::prefetch_index;

/// The two numbers at a position.
#[inline(always)]
pub fn at<T: Copy, C: Deref<Target = [T]>>(columns: &[C; 2], position: usize) -> [T; 2] {
    [columns[0][position], columns[1][position]]
}

/// Prefetch the line of each column that holds a position.
#[inline(always)]
pub fn prefetch<T, C: Deref<Target = [T]>>(columns: &[C; 2], position: usize) {
    for column in columns {
        prefetch_index(&**column, position);
    }
}

/// Replace the two numbers at a position.
#[inline(always)]
pub fn put<T, C: DerefMut<Target = [T]>>(
    columns: &mut [C; 2],
    position: usize,
    [first, second]: [T; 2],
) {
    columns[0][position] = first;
    columns[1][position] = second;
}

/// The columns at some positions, to be changed.
#[inline(always)]
pub fn part_mut<'a, T>(
    [first, second]: &'a mut [&mut [T]; 2],
    positions: Range<usize>,
) -> [&'a mut [T]; 2] {
    [&mut first[positions.clone()], &mut second[positions]]
}

/// The columns before and from a position on.
pub fn split<T>(columns: [&[T]; 2], at: usize) -> ([&[T]; 2], [&[T]; 2]) {
    let [(first, other_first), (second, other_second)] = columns.map(|column| column.split_at(at));
    ([first, second], [other_first, other_second])
}

/// The columns before and from a position on, to be changed; columns may be empty.
pub fn split_mut<T>([first, second]: [&mut [T]; 2], at: usize) -> ([&mut [T]; 2], [&mut [T]; 2]) {
    let (first, other_first) = halves(first, at);
    let (second, other_second) = halves(second, at);
    ([first, second], [other_first, other_second])
}

/// Both columns as slices.
#[inline(always)]
pub fn slices<T>([first, second]: &[Vec<T>; 2]) -> [&[T]; 2] {
    [first, second]
}

/// Both columns as slices, to be changed.
#[inline(always)]
pub fn slices_mut<T>([first, second]: &mut [Vec<T>; 2]) -> [&mut [T]; 2] {
    [first, second]
}

/// Columns of two numbers of each item.
pub fn collect<I, T: Copy>(items: &[I], of: impl Fn(&I) -> [T; 2]) -> [Vec<T>; 2] {
    [0, 1].map(|which| items.iter().map(|item| of(item)[which]).collect())
}
