//! The ends of every checkpoint.
//!
//! A checkpoint begins with the magic bytes, the fingerprint of the scene and the version of the format, and ends with
//! a checksum. All numbers are words of eight bytes, the least significant byte first.

use super::bytes::{Reader, put_words};
use super::fingerprint::Fingerprint;
use sha2::{Digest, Sha256};

/// First bytes of every checkpoint.
const MAGIC: &[u8; 16] = b"gouge checkpoint";
/// Version of the format.
const VERSION: u64 = 9;
/// Bytes of a checksum or fingerprint.
const DIGEST: usize = 32;
/// Bytes before the version.
const PREFIX: usize = MAGIC.len() + DIGEST;

/// The beginning of a checkpoint.
pub fn begin(fingerprint: &Fingerprint) -> Vec<u8> {
    let mut bytes = MAGIC.to_vec();
    bytes.extend(fingerprint.0);
    put_words(&mut bytes, &[VERSION]);
    bytes
}

/// A checkpoint with its end.
pub fn seal(mut bytes: Vec<u8>) -> Vec<u8> {
    let digest = Sha256::digest(&bytes);
    bytes.extend(digest);
    bytes
}

/// The fingerprint and the content of a checkpoint.
///
/// # Errors
/// What is wrong with it.
pub fn open(bytes: &[u8]) -> Result<(&[u8], Reader<'_>), &'static str> {
    if bytes.len() < PREFIX + DIGEST || !bytes.starts_with(MAGIC) {
        return Err("it is not a checkpoint, or its beginning is damaged");
    }
    let (content, digest) = bytes.split_at(bytes.len() - DIGEST);
    if Sha256::digest(content)[..] != *digest {
        return Err("it is damaged: its checksum does not match its content");
    }
    let mut rest = Reader(&content[PREFIX..]);
    match rest.word() {
        Some(VERSION) => Ok((&content[MAGIC.len()..PREFIX], rest)),
        Some(_) => Err("it was written by another version of the program"),
        None => Err("it is damaged: its beginning is missing"),
    }
}
