//! Fragments: what bonds hold together.

/// The connected components of a graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fragments {
    /// How many there are; a particle without bonds is one of its own.
    pub number: usize,
    /// Fragment of each particle, numbered in the order of their first particles.
    pub label: Vec<usize>,
}

/// Connected components of a graph with so many nodes, by union of the smaller root.
pub fn connected(nodes: usize, edges: impl Iterator<Item = (usize, usize)>) -> Fragments {
    let mut parent: Vec<usize> = (0..nodes).collect();
    for (i, j) in edges {
        let (a, b) = (root(&mut parent, i), root(&mut parent, j));
        parent[a.max(b)] = a.min(b);
    }
    let mut label = vec![0; nodes];
    let mut number = 0;
    for i in 0..nodes {
        let first = root(&mut parent, i);
        if first == i {
            label[i] = number;
            number += 1;
        } else {
            label[i] = label[first];
        }
    }
    Fragments { number, label }
}

/// Root of a node, halving the path on the way.
fn root(parent: &mut [usize], mut node: usize) -> usize {
    while parent[node] != node {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    node
}
