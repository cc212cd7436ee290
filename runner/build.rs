//! The program carries a copy of the folder `references`: it is built again when that changes.

fn main() {
    println!("cargo::rerun-if-changed=../references");
}
