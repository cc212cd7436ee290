//! Fragments: particles held together by bonds.

/// The connected components of a graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fragments {
    /// Number of fragments; a particle without bonds is a fragment of its own.
    pub number: usize,
    /// Fragment of each particle; fragments are numbered in the order of their first particles.
    pub label: Vec<usize>,
}

/// Connected components of a graph with `nodes` nodes, by union-find.
///
/// The root of a component is its smallest node.
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

/// Root of a node; shortens the path by halving.
fn root(parent: &mut [usize], mut node: usize) -> usize {
    while parent[node] != node {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    node
}
