//! Connected components of a graph, by flood fill.

/// For each node the first node of its component, by flood fill from every node in turn.
pub fn first_nodes(nodes: usize, edges: &[(usize, usize)]) -> Vec<usize> {
    let mut neighbors = vec![Vec::new(); nodes];
    for &(i, j) in edges {
        neighbors[i].push(j);
        neighbors[j].push(i);
    }
    let mut first = vec![usize::MAX; nodes];
    for start in 0..nodes {
        let mut open = vec![start];
        while let Some(node) = open.pop() {
            if first[node] == usize::MAX {
                first[node] = start;
                open.extend(&neighbors[node]);
            }
        }
    }
    first
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_chain_and_a_loner() {
        assert_eq!(super::first_nodes(4, &[(3, 1), (1, 0)]), [0, 0, 2, 0]);
    }
}
