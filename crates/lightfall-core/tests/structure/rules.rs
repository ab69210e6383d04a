//! The rules that imports keep: no module uses one above it, and no files form a circle.

use crate::graph::{Graph, Module, Use};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Imports that run up in `order`, which lists modules of one depth as `crate::module`, lowest
/// first, and modules beside them that have no place in it. One sentence for each.
pub fn upward_imports(graph: &Graph, order: &[&str]) -> Vec<String> {
    let depth = order[0].split("::").count();
    let rank = |module: &Module| {
        let top = module[..module.len().min(depth)].join("::");
        order.iter().position(|name| *name == top)
    };
    let parents: BTreeSet<&str> = order
        .iter()
        .filter_map(|name| name.rsplit_once("::"))
        .map(|(parent, _)| parent)
        .collect();
    let mut faults = BTreeSet::new();
    for module in graph.modules().filter(|module| module.len() >= depth) {
        let parent = module[..depth - 1].join("::");
        if parents.contains(parent.as_str()) && rank(module).is_none() {
            let top = module[..depth].join("::");
            faults.insert(format!("the module {top} has no place in the order"));
        }
    }
    for import in graph.uses() {
        if let (Some(from), Some(to)) = (rank(&import.from), rank(&import.to))
            && from < to
        {
            faults.insert(format!(
                "{}, but {} is below {}",
                sentence(graph, &import),
                order[from],
                order[to]
            ));
        }
    }
    faults.into_iter().collect()
}

/// A set of files each of which leads to every other by imports, and the shortest circle in it.
pub struct Circle {
    /// The files' names, in order.
    pub files: Vec<String>,
    /// One sentence for each import of the shortest circle.
    pub imports: Vec<String>,
}

impl Circle {
    /// The circle as a message.
    pub fn describe(&self) -> String {
        format!(
            "{} files import each other in a circle ({}):\n    {}",
            self.files.len(),
            self.files.join(", "),
            self.imports.join("\n    ")
        )
    }
}

/// Every circle of files among the modules of the crate `crate_name`.
pub fn circles(graph: &Graph, crate_name: &str) -> Vec<Circle> {
    let mut uses: BTreeMap<Module, Vec<Use>> = BTreeMap::new();
    for import in graph.uses() {
        if import.from[0] == crate_name && import.to[0] == crate_name {
            uses.entry(import.from.clone()).or_default().push(import);
        }
    }
    let modules: Vec<&Module> = graph.modules().collect();
    let mut left: BTreeSet<Module> = modules.into_iter().cloned().collect();
    let reach: BTreeMap<Module, BTreeSet<Module>> = left
        .iter()
        .map(|from| (from.clone(), reachable(&uses, from)))
        .collect();
    let mut found = Vec::new();
    while let Some(module) = left.pop_first() {
        let ring: Vec<Module> = reach[&module]
            .iter()
            .filter(|other| reach[*other].contains(&module))
            .cloned()
            .collect();
        if ring.is_empty() {
            continue;
        }
        left.retain(|other| !ring.contains(other));
        let shortest = ring
            .iter()
            .filter_map(|start| shortest_circle(&uses, start))
            .min_by_key(Vec::len)
            .unwrap_or_default();
        let mut files: Vec<String> = ring
            .iter()
            .map(|module| graph.file(module).to_owned())
            .collect();
        files.sort();
        found.push(Circle {
            files,
            imports: shortest
                .iter()
                .map(|import| sentence(graph, import))
                .collect(),
        });
    }
    found
}

fn sentence(graph: &Graph, import: &Use) -> String {
    format!(
        "{}:{} imports {} from {}",
        graph.file(&import.from),
        import.line,
        import.path,
        graph.file(&import.to)
    )
}

/// Every module that `from` leads to by one import or more.
fn reachable(uses: &BTreeMap<Module, Vec<Use>>, from: &Module) -> BTreeSet<Module> {
    let mut found = BTreeSet::new();
    let mut open = vec![from.clone()];
    while let Some(module) = open.pop() {
        for import in uses.get(&module).into_iter().flatten() {
            if found.insert(import.to.clone()) {
                open.push(import.to.clone());
            }
        }
    }
    found
}

/// The fewest imports that lead from `start` back to it.
fn shortest_circle(uses: &BTreeMap<Module, Vec<Use>>, start: &Module) -> Option<Vec<Use>> {
    let mut came_by: BTreeMap<Module, Use> = BTreeMap::new();
    let mut open = VecDeque::from([start.clone()]);
    while let Some(module) = open.pop_front() {
        for import in uses.get(&module).into_iter().flatten() {
            if came_by.contains_key(&import.to) {
                continue;
            }
            came_by.insert(import.to.clone(), import.clone());
            if import.to == *start {
                let mut circle = vec![import.clone()];
                while circle[0].from != *start {
                    circle.insert(0, came_by[&circle[0].from].clone());
                }
                return Some(circle);
            }
            open.push_back(import.to.clone());
        }
    }
    None
}
