//! Laws and database of lubricant and solid properties, in SI; knows no mesh.
