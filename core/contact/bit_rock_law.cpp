// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bit_rock_law.h"

#include <cassert>
#include <cmath>

#include "core/contact/contact_law.h"
#include "core/model/scales.h"

namespace drillwave {

namespace {

/// U/U1 and F/(βU1) of a node.
struct Node {
    double penetration, force;
};
Node nodeOf(int i, double exponent) {
    const double penetration = std::exp2(i / 4.0);
    return {penetration, std::pow(penetration, exponent)};
}

constexpr int firstNode = -32, lastNode = 31;

/// Where the line of the slope `steepest` from zero meets the line from `a` on of that slope.
Node crossing(const Node& a, double slope, double steepest) {
    const double penetration = (a.force - slope * a.penetration) / (steepest - slope);
    return {penetration, steepest * penetration};
}

}  // namespace

void setPowerLines(BitRockLaw& law, double exponent, double reference) {
    assert(reference > 0 && exponent > 0);
    law.firstSlope = 1;
    law.corners.clear();
    if (exponent == 1) return;
    const double steepest = 1 / law.gamma, force = law.beta * reference;
    Node from{0, 0}, to = nodeOf(firstNode, exponent);
    double before = std::min(to.force / to.penetration, steepest);
    law.firstSlope = before;
    const auto turn = [&](const Node& at, double slope) {
        // The steepest line may end at a node, to the last digit: there is one corner then.
        if (!law.corners.empty() && law.corners.back().force >= force * at.force) law.corners.pop_back();
        law.corners.push_back({force * at.force, slope});
        before = slope;
    };
    bool isCut = exponent < 1 && to.force / to.penetration > steepest;  // it begins on β/γ
    for (int i = firstNode; i < lastNode; ++i) {
        from = to;
        to = nodeOf(i + 1, exponent);
        const double slope = (to.force - from.force) / (to.penetration - from.penetration);
        if (isCut) {
            if (to.force > steepest * to.penetration) continue;
            turn(crossing(from, slope, steepest), slope);
            isCut = false;
        } else if (slope >= steepest) {  // and for p > 1 so is all that follows
            if (before < steepest) turn(from, steepest);
            return;
        } else {
            turn(from, slope);
        }
    }
}

void setLines(BitRockLaw& law, const Scenario& scenario) {
    const BitRock& rock = scenario.bitRock;
    law.firstSlope = 1;
    law.corners.clear();
    if (rock.law == RockLaw::bilinear) return;
    const Scales scales = hasUnits(scenario) ? scalesOf(scenario) : Scales{};
    if (rock.law == RockLaw::power) {
        setPowerLines(law, rock.exponent,
                      rock.referencePenetration / scales.penetration / lawUnitOfPenetration);
        return;
    }
    for (const RockCorner& corner : rock.corners)
        law.corners.push_back({corner.force / scales.force, corner.slope});
}

}  // namespace drillwave
