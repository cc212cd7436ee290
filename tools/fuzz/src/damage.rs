//! Damages files at random places.

use rand::RngExt;
use rand_pcg::Pcg64;

/// Longest file in bytes.
const LONGEST: usize = 1 << 16;
/// Longest piece that is copied, removed or inserted, in bytes.
const PIECE: usize = 64;

/// Values at which programs fail.
const EXTREMES: [&str; 24] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "inf",
    "-inf",
    "nan",
    "1e15",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551616",
    "0x7f",
    "4294967296",
    "1_0",
    "true",
    "\"\"",
    "[]",
    "{}",
    "1e999",
    "0.1e-1",
];
/// Words of eight bytes at which programs fail.
const WORDS: [u64; 10] = [
    0,
    1,
    2,
    u64::MAX,
    1 << 63,
    0x7ff8_0000_0000_0000,
    0x7ff0_0000_0000_0000,
    0x7e37_e43c_8800_759c,
    1 << 32,
    0xffff_ffff,
];

/// A file with one to eight damages. `others` are files from which pieces are taken.
pub fn damaged(file: &[u8], others: &[Vec<u8>], is_text: bool, random: &mut Pcg64) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..random.random_range(1..=8) {
        match is_text && random.random_range(0..2) == 0 {
            true => damage_text(&mut bytes, others, random),
            false => damage_bytes(&mut bytes, is_text, random),
        }
        bytes.truncate(LONGEST);
    }
    bytes
}

fn place(length: usize, random: &mut Pcg64) -> usize {
    random.random_range(0..=length)
}

fn range(length: usize, random: &mut Pcg64) -> std::ops::Range<usize> {
    let start = place(length, random);
    start..(start + random.random_range(0..=PIECE)).min(length)
}

fn damage_bytes(bytes: &mut Vec<u8>, is_text: bool, random: &mut Pcg64) {
    let length = bytes.len();
    match random.random_range(0..7) {
        0 if length > 0 => bytes[random.random_range(0..length)] ^= 1 << random.random_range(0..8),
        1 if length > 0 => bytes[random.random_range(0..length)] = random.random(),
        2 => {
            bytes.drain(range(length, random));
        }
        3 => {
            let piece = bytes[range(length, random)].to_vec();
            let at = place(length, random);
            bytes.splice(at..at, piece);
        }
        4 => bytes.truncate(place(length, random)),
        5 => {
            let at = place(length, random);
            let piece: Vec<u8> = (0..random.random_range(1..PIECE))
                .map(|_| random.random())
                .collect();
            bytes.splice(at..at, piece);
        }
        _ if !is_text && length >= 8 => {
            let at = random.random_range(0..length / 8) * 8;
            let word = WORDS[random.random_range(0..WORDS.len())];
            bytes[at..at + 8].copy_from_slice(&word.to_le_bytes());
        }
        _ => {}
    }
}

fn damage_text(bytes: &mut Vec<u8>, others: &[Vec<u8>], random: &mut Pcg64) {
    match random.random_range(0..4) {
        0 | 1 => {
            let extreme = EXTREMES[random.random_range(0..EXTREMES.len())];
            let tokens = tokens(bytes);
            if !tokens.is_empty() {
                let token = tokens[random.random_range(0..tokens.len())].clone();
                bytes.splice(token, extreme.bytes());
            }
        }
        2 => {
            let lines: Vec<Vec<u8>> = bytes
                .split(|&byte| byte == b'\n')
                .map(<[u8]>::to_vec)
                .collect();
            let mut lines = lines;
            let (a, b) = (
                random.random_range(0..lines.len()),
                random.random_range(0..lines.len()),
            );
            lines.swap(a, b);
            *bytes = lines.join(&b'\n');
        }
        _ => {
            let other = &others[random.random_range(0..others.len())];
            let lines: Vec<&[u8]> = other.split(|&byte| byte == b'\n').collect();
            let line = [lines[random.random_range(0..lines.len())], b"\n"].concat();
            let breaks = bytes
                .iter()
                .enumerate()
                .filter(|(_, byte)| **byte == b'\n')
                .map(|(at, _)| at + 1);
            let places: Vec<usize> = breaks.chain([0]).collect();
            let at = places[random.random_range(0..places.len())];
            bytes.splice(at..at, line);
        }
    }
}

/// The places of all numbers, names and texts.
fn tokens(bytes: &[u8]) -> Vec<std::ops::Range<usize>> {
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || b"+-._\"".contains(&byte);
    let mut tokens = Vec::new();
    let mut start = None;
    for (at, &byte) in bytes.iter().chain(b" ").enumerate() {
        match (is_part(byte), start) {
            (true, None) => start = Some(at),
            (false, Some(from)) => {
                tokens.push(from..at);
                start = None;
            }
            _ => {}
        }
    }
    tokens
}
