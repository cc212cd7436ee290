//! The program embeds a copy of the folder `references`, so it is rebuilt if the folder changes.

fn main() {
    println!("cargo::rerun-if-changed=../references");
}
