// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/census_impact.h"

namespace drillwave {

NetworkImpact impactOf(const Problem& problem, const CensusResult& census) {
    NetworkImpact impact;
    impact.endTime = census.time;
    for (std::size_t j = 0; j < problem.hammerSections(); ++j)
        impact.hammerMass += problem.sections[j].mass() + problem.sections[j].massAfter;
    const FaceRecord& face = census.face.record;
    if (problem.isForced()) {
        impact.hammerMomentum = face.impulse;
        impact.hammerEnergy = face.work;
    } else {
        const double velocity = problem.hammer().velocity;
        impact.hammerMomentum = impact.hammerMass * velocity;
        impact.hammerEnergy = impact.hammerMomentum * velocity / 2;
    }
    const double e0 = impact.hammerEnergy;

    BilinearLaw<double> law = census.bit.law;
    law.remember(census.bit.force);
    const double force = census.bit.isApart() ? 0 : census.bit.force;
    impact.energy = {law.worked(force) / e0, census.hammerEnergy / e0, census.stringEnergy / e0,
                     census.jointLoss / e0,  census.rodLoss / e0,      census.faceEnergy / e0};
    const NetworkLedger& energy = impact.energy;
    impact.energyResidual =
        1 - energy.rock - energy.hammer - energy.string - energy.joints - energy.rods - energy.face;
    const BitRecord& rock = census.bit.record;
    impact.rockImpulse = rock.impulse;
    impact.pistonMomentum = census.hammerMomentum;
    impact.stringMomentum = census.stringMomentum;
    impact.externalMomentum = census.externalMomentum;
    impact.momentumResidual = (impact.hammerMomentum - rock.impulse - census.hammerMomentum -
                               census.stringMomentum - census.externalMomentum) /
                              impact.hammerMomentum;
    impact.peakForce = rock.peakForce;
    impact.peakTime = rock.peakTime;
    impact.largestPenetration = law.largestPenetration();
    impact.residualPenetration = law.residualPenetration();
    impact.firstContact = rock.firstContact;
    impact.lastSeparation = rock.lastSeparation;
    if (census.bit.isApart() && rock.contacts > 0)
        impact.endOfBlow = rock.lastSeparation + problem.transitTime();
    impact.contactDuration = rock.contactDuration;
    impact.contacts = rock.contacts;
    impact.faceImpulse = face.impulse;
    impact.faceSeparation = face.firstSeparation;
    return impact;
}

}  // namespace drillwave
