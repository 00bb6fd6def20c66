//! Geometry of two involute gears on parallel axes, without profile shift.

/// Two external gears that touch at the pitch cylinders, in a transverse section; lengths in m, angles in rad, pinion first.
pub(super) struct Pair {
    /// Transverse module m_t.
    pub module: f64,
    /// Transverse pressure angle α_t.
    pub pressure_angle: f64,
    /// Inclination β_b of the contact line to the axes.
    pub base_helix_angle: f64,
    pub pitch_radii: [f64; 2],
    pub addenda: [f64; 2],
}

impl Pair {
    /// Of the module m_n (m) and the pressure angle α_n in the normal section of teeth under the helix angle β; straight teeth have β = 0.
    ///
    /// m_t = m_n/cos β,  tan α_t = tan α_n/cos β,  tan β_b = tan β cos α_t,  r = m_t z/2
    ///
    /// Source: ISO 21771:2007, 4.2 to 4.4.
    pub fn new(
        normal_module: f64,
        normal_pressure_angle: f64,
        helix_angle: f64,
        teeth: [f64; 2],
        addenda: [f64; 2],
    ) -> Pair {
        let cosine = helix_angle.cos();
        let module = normal_module / cosine;
        // tan(α_t − α_n) = (tan α_t − tan α_n)/(1 + tan α_t tan α_n), which straight teeth leave at α_n to the last bit.
        let tangent = normal_pressure_angle.tan();
        let turn = tangent * (1.0 / cosine - 1.0) / (1.0 + tangent * tangent / cosine);
        let pressure_angle = normal_pressure_angle + turn.atan();
        Pair {
            module,
            pressure_angle,
            base_helix_angle: (helix_angle.tan() * pressure_angle.cos()).atan(),
            pitch_radii: teeth.map(|z| 0.5 * module * z),
            addenda,
        }
    }

    /// Radius of the pinion's base circle: r_b = r cos α_t.
    pub fn base_radius(&self) -> f64 {
        self.pitch_radii[0] * self.pressure_angle.cos()
    }

    /// Radii of curvature of the two flanks in the transverse section at the distance s (m) from the pitch point along the line of
    /// action: the distances from the points where it touches the base circles.
    ///
    /// R_1 = r_1 sin α_t + s,  R_2 = r_2 sin α_t − s
    pub fn flank_radii(&self, s: f64) -> [f64; 2] {
        let sine = self.pressure_angle.sin();
        [
            self.pitch_radii[0] * sine + s,
            self.pitch_radii[1] * sine - s,
        ]
    }

    /// Reduced radius (m) across the contact line of flanks with the transverse radii R_1 and R_2. A flank is a developable surface whose
    /// straight line is the contact line; a plane across it cuts the base cylinder at β_b.
    ///
    /// R = R_1 R_2/(R_1 + R_2)/cos β_b
    pub fn reduced_radius(&self, flanks: [f64; 2]) -> f64 {
        flanks[0] * flanks[1] / (flanks[0] + flanks[1]) / self.base_helix_angle.cos()
    }

    /// How far the flank of one gear reaches beyond the pitch point: its addendum circle r_a cuts the line of action at
    /// √(r_a² − r_b²) from the base circle.
    ///
    /// s = √((r + h_a)² − r² cos² α_t) − r sin α_t
    fn reach(&self, gear: usize) -> f64 {
        let (r, tip) = (
            self.pitch_radii[gear],
            self.pitch_radii[gear] + self.addenda[gear],
        );
        let base = r * self.pressure_angle.cos();
        (tip * tip - base * base).sqrt() - r * self.pressure_angle.sin()
    }

    /// Thickness of the teeth of a gear at their tips, m, in the transverse section; negative where the flanks cross before.
    ///
    /// s_a = 2 r_a [π/(2z) + inv α_t − inv α_a],  cos α_a = r_b/r_a,  inv α = tan α − α
    ///
    /// Source: ISO 21771:2007, tooth thickness at a circle, of teeth as thick as their spaces at the pitch circle.
    pub fn tip_thickness(&self, gear: usize) -> f64 {
        let involute = |angle: f64| angle.tan() - angle;
        let (r, tip) = (
            self.pitch_radii[gear],
            self.pitch_radii[gear] + self.addenda[gear],
        );
        let at_tip = (r * self.pressure_angle.cos() / tip).acos();
        let half_angle = std::f64::consts::PI * self.module / (4.0 * r);
        2.0 * tip * (half_angle + involute(self.pressure_angle) - involute(at_tip))
    }

    /// Whether the tip of the other gear reaches inside the base circle of this one, where there is no involute: there it meets the fillet,
    /// or the cutter that made room for it has cut away some of the flank.
    pub fn is_undercut(&self, gear: usize) -> bool {
        let own = self.flank_radii(0.0)[gear];
        self.reach(1 - gear) > own * (1.0 + 1e-9)
    }

    /// The path of contact, from the tip of the wheel to that of the pinion, but not beyond the base circles, inside which
    /// there is no involute.
    pub fn path(&self) -> [f64; 2] {
        let [first, second] = self.flank_radii(0.0);
        [-self.reach(1).min(first), self.reach(0).min(second)]
    }

    /// Transverse contact ratio: ε_α = length of the path of contact/(π m_t cos α_t).
    pub fn contact_ratio(&self) -> f64 {
        let [from, to] = self.path();
        let pitch = std::f64::consts::PI * self.module * self.pressure_angle.cos();
        (to - from) / pitch
    }
}
