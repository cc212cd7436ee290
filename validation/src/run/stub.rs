pub struct Fragments {
    pub number: usize,
    pub label: Vec<usize>,
}
pub fn fragments(world: &gouge_kernel::World) -> Fragments {
    let n = world.particles().len();
    let mut parent: Vec<usize> = (0..n).collect();
    fn root(p: &mut [usize], mut i: usize) -> usize {
        while p[i] != i {
            p[i] = p[p[i]];
            i = p[i];
        }
        i
    }
    for l in world.strong_links().map_or(&[][..], |s| &s.links) {
        let (i, j) = l.pair.indices();
        let (a, b) = (root(&mut parent, i), root(&mut parent, j));
        let (a, b) = (a.min(b), a.max(b));
        parent[b] = a;
    }
    let mut label = vec![0; n];
    let mut number = 0;
    for i in 0..n {
        let r = root(&mut parent, i);
        if r == i {
            label[i] = number;
            number += 1;
        } else {
            label[i] = label[r];
        }
    }
    Fragments { number, label }
}
