// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/census_impact.h"

#include <algorithm>

#include "core/contact/contact_law.h"

namespace drillwave {

namespace {

/// Negative: never.
double timeOrNever(double time) {
    return time >= 0 ? time : Impact::never;
}

}  // namespace

Impact impactOf(const Problem& problem, const CensusResult& census) {
    const FaceRecord& face = census.face.record;
    Impact impact;
    impact.endTime = census.time;
    if (problem.isForced()) {
        impact.hammerImpulse = face.impulse;
        impact.hammerWork = face.work;
    } else {
        double mass = 0;
        for (std::size_t j = 0; j < problem.hammerSections(); ++j)
            mass += problem.sections[j].mass() + problem.sections[j].massAfter;
        impact.hammerImpulse = mass * problem.velocity();
        impact.hammerWork = impact.hammerImpulse * problem.velocity() / 2;
    }

    ContactLaw<double> law = census.bit.law;
    law.remember(census.bit.force);
    impact.rockWork = law.worked(census.bit.isApart() ? 0 : census.bit.force);
    impact.hammerEnergy = census.hammerEnergy;
    impact.finalEnergy = census.stringEnergy;
    impact.jointLoss = census.jointLoss;
    impact.rodLoss = census.rodLoss;
    impact.faceEnergy = census.faceEnergy;

    const BitRecord& rock = census.bit.record;
    impact.impulse = rock.impulse;
    impact.hammerMomentum = census.hammerMomentum;
    impact.finalMomentum = census.stringMomentum;
    impact.externalMomentum = census.externalMomentum;
    impact.faceImpulse = face.impulse;
    impact.faceSeparation = timeOrNever(face.firstSeparation);
    // momentum that losses take from the string is not rebound; rounding must not give less than −1
    if (face.impulse > 0)
        impact.cor = losesWaves(problem) ? rock.impulse / face.impulse - 1
                                         : std::max(-1.0, -census.stringMomentum / face.impulse);

    impact.peakForce = rock.peakForce;
    impact.peakTime = rock.peakTime;
    impact.firstContactTime = timeOrNever(rock.firstContact);
    impact.separationTime = timeOrNever(rock.lastSeparation);
    if (census.bit.isApart() && rock.contacts > 0)
        impact.endOfBlow = rock.lastSeparation + problem.transitTime();
    impact.contactDuration = rock.contactDuration;
    impact.contacts = rock.contacts;
    return impact;
}

}  // namespace drillwave
