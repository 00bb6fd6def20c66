//! Files that still use each other in a circle. A circle that is broken leaves the list; none is added.

/// Each circle: its folder, and the files there.
pub const CIRCLES: [[&str; 2]; 5] = [
    [
        "ertel/src/case",
        "approach bodies builder check contact course curve described echo friction geometry inputs lubricant \
         machine/ball_bearing machine/ball_on_disc machine/bearing machine/cam machine/cam_turn machine/cam_turn/doubts \
         machine/cam_turn/lift machine/gears/dimensions machine/gears/load machine/gears/mod machine/gears/path \
         machine/loaded_bearing/geometry machine/loaded_bearing/mod machine/loaded_bearing/refusal \
         machine/loaded_bearing/rollers machine/mod machine/passage machine/roller_bearing machine/spin machine/whole \
         mod motion roller roughness set settings study/axis study/columns study/in_time study/mod study/points surface/array \
         surface/coverage surface/map surface/mod thermal time_warnings transient usual",
    ],
    [
        "ertel/src/fit",
        "entry law mod picture ranking sense walther",
    ],
    ["ertel/src/machine", "heat mod"],
    [
        "ertel/src/output",
        "compare/folder cross_check curve/mod folder html/instants html/mod machine/mod mod monte_carlo target transient/animation transient/fields transient/mod transient/picture workplace",
    ],
    ["ertel/src/study", "curve machine point"],
];
