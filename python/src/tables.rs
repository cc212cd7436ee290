//! Columns as NumPy arrays.

use gouge::runner::run::{Table, Values};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Make ready for arrays. To be called where no signal can come between: it panics then.
#[pyfunction]
pub fn load_numpy(py: Python<'_>) {
    numbers(py, Vec::new());
}

/// One number per item: shape (n,).
pub fn numbers(py: Python<'_>, column: Vec<f64>) -> Bound<'_, PyAny> {
    PyArray1::from_vec(py, column).into_any()
}

/// Two numbers per item: shape (n, 2).
pub fn pairs<'py>(
    py: Python<'py>,
    column: impl ExactSizeIterator<Item = [f64; 2]>,
) -> PyResult<Bound<'py, PyAny>> {
    let rows = column.len();
    let flat: Vec<f64> = column.collect::<Vec<_>>().into_flattened();
    let array = PyArray1::from_vec(py, flat).reshape([rows, 2])?;
    Ok(array.into_any())
}

/// A table as a dict from the names of its columns to arrays; categories are lists of their names.
pub fn columns<'py>(py: Python<'py>, table: Table) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (name, values) in table.columns {
        let column = match values {
            Values::Numbers(column) => numbers(py, column),
            Values::Integers(column) => {
                let column = column.into_iter().map(|number| number as i64).collect();
                PyArray1::from_vec(py, column).into_any()
            }
            Values::Kinds(kinds) => {
                let names = kinds.codes.iter().map(|&code| kinds.names[code]);
                PyList::new(py, names.collect::<Vec<_>>())?.into_any()
            }
        };
        dict.set_item(name, column)?;
    }
    Ok(dict)
}
