//! The files that come with the crate.

/// Name and text of the files of a folder.
pub(super) type Folder = [(&'static str, &'static str)];

macro_rules! folder {
    ($folder:literal, $suffix:literal: $($name:literal)*) => {
        &[$(($name, include_str!(concat!("../../data/", $folder, "/", $name, $suffix)))),*]
    };
}

pub(super) const FLUIDS: &Folder = folder!("fluids", ".toml":
    "ammonia" "ester-iso-vg-320" "ester-kr-015" "fva-3" "gear-oil-80w-90" "glycerol" "holmes-evans-oil"
    "iso-vg-100-mineral" "iso-vg-100-pao" "iso-vg-150-mineral" "iso-vg-150-pao" "iso-vg-220-mineral" "iso-vg-220-pao"
    "iso-vg-32-mineral" "iso-vg-32-pao" "iso-vg-320-mineral" "iso-vg-320-pao" "iso-vg-46-mineral" "iso-vg-46-pao"
    "iso-vg-460-mineral" "iso-vg-460-pao" "iso-vg-68-mineral" "iso-vg-68-pao" "iso-vg-680-mineral" "iso-vg-680-pao"
    "liquid-oxygen" "mil-l-23699-ester" "mil-l-7808-ester" "mourier-oil" "n-decane" "n-dodecane" "n-nonane" "n-octane"
    "nynas-hp12" "nynas-hp4" "nynas-t22" "nynas-t9" "pag-iso-vg-320" "pao-10" "pao-100" "pao-4" "pao-40" "pao-650"
    "polyphenyl-ether-5p4e" "r123" "r1234yf" "r134a" "r152a" "r245fa" "r32" "santotrac-30" "santotrac-50"
    "squalane-pip" "thesis-fluid-a" "thesis-fluid-b" "thesis-fluid-c" "thesis-roelands-oil" "thesis-wlf-oil" "toluene"
    "turbine-oil-sae-30" "venner-oil" "water");

pub(super) const TABLES: &Folder = folder!("fluids", "":
    "ammonia.csv" "liquid-oxygen.csv" "n-decane.csv" "n-dodecane.csv" "n-nonane.csv" "n-octane.csv" "r123.csv"
    "r1234yf.csv" "r134a.csv" "r152a.csv" "r245fa.csv" "r32.csv" "toluene.csv" "water.csv");

pub(super) const SOLIDS: &Folder = folder!("solids", ".toml":
    "austempered-ductile-iron" "bearing-steel" "chromium-nitride" "dlc" "gear-steel" "glass" "pa66" "peek" "pom"
    "sapphire" "silicon-nitride" "soda-lime-glass" "steel" "titanium-nitride");
