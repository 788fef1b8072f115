// Waves anywhere in the rod, by shifted look-up in the histories of the front end (theory §3).
#pragma once

#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

/// Incident wave g(s) at the front end for any s: 0 before the first front, recorded history, then periodic.
double incidentWave(const Impact& impact, double s);

/// Np(ξ, t) = −g(t − arrival + (1 − ξ)τ …): wave to +x, tension positive, in F0. ξ = x/L in [0, 1], t global.
double positiveWave(const Impact& impact, double xi, double t);

/// Nn(ξ, t) = −r(s), r = F − g: wave to −x, tension positive, in F0.
double negativeWave(const Impact& impact, double xi, double t);

/// Momentum of the rod at global time t: hammer impulse so far minus impact impulse so far, in I0.
/// `hammerImpulse` is ∫Fa up to t (1 for the reference case).
double momentum(const Impact& impact, double hammerImpulse, double t);

/// One wave of Fig. 3 at a section: N0p, N1n, N2p, N3n … cut by arrival. Times global, values in F0.
struct SectionWave {
    int number = 0;            ///< 0, 1, 2, 3: even ones run to +x, odd ones to −x
    std::vector<double> time;  ///< increasing; doubled where the wave jumps
    std::vector<double> value;
};

/// The waves N0p … at the section ξ, each over its own interval of one round trip from its arrival, sampled so
/// that straight lines between samples follow the curve to about 1e-4 of the peak, jumps kept as jumps.
/// `count` waves (4 as in Fig. 3).
std::vector<SectionWave> sectionWaves(const Impact& impact, double xi, int count = 4);

/// Sampled history: times and values with doubled times at jumps, for plots and CSV.
struct SampledHistory {
    std::vector<double> time;      ///< global, increasing
    std::vector<double> force;     ///< F/F0
    std::vector<double> impulse;   ///< ∫F/I0 so far
    std::vector<double> incident;  ///< g/F0 at the front end
};

/// Impact force, its impulse and the incident wave from s = 0 to a little after the last separation; at least
/// `minimumSamples`, every breakpoint included.
SampledHistory sampleHistory(const Impact& impact, int minimumSamples = 400);

}  // namespace drillwave
