// SPDX-License-Identifier: GPL-3.0-or-later
// All that moves at one time: momentum, energy, penetration, gap.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/wave/network/bit_node.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Integrals of one wave of a section: of what had gone through it before, and of what is in it.
struct LineSums {
    double passed = 0, passedSquare = 0;    ///< ∫ and ∫² of what has left it, as it entered
    double entered = 0, enteredSquare = 0;  ///< of what is in it, as it entered
    double present = 0, presentSquare = 0;  ///< of what is in it, as it is now
};

/// The sums over one wave between two clock times while cells go by.
class LineCensus {
  public:
    /// What has entered in [from, to] is in the line; it loses `decay` of the logarithm of its amplitude over
    /// that time. Before clock 0 the wave was `before`.
    LineCensus(double from, double to, double decay, double before);

    /// Whether cells between two clock times matter; what passed before only does where something is lost.
    bool concerns(double start, double end, bool losses) const {
        return start < m_to && (losses || end > m_from);
    }
    /// A cell that enters at clock `start`.
    void add(const WaveCell& cell, double start, double width) {
        if (start >= m_to) return;
        if (start + width <= m_from) {
            m_sums.passed += width * cell.mean();
            m_sums.passedSquare += width * cell.meanSquare();
        } else if (start >= m_from && start + width <= m_to && m_decay == 0) {
            m_sums.entered += width * cell.mean();
            m_sums.enteredSquare += width * cell.meanSquare();
            m_sums.present = m_sums.entered;
            m_sums.presentSquare = m_sums.enteredSquare;
        } else {
            addAcross(cell, start, width);
        }
    }
    /// What of the cell that begins at clock `start` has entered at `to`. A cell has the moments of its wave
    /// as a whole only: a part of it has others.
    void setEntered(const WaveCell& part, double start) { m_entered = {part, start}; }
    const LineSums& sums() const { return m_sums; }

  private:
    void addAcross(const WaveCell& cell, double start, double width);

    double m_from, m_to, m_decay;
    LineSums m_sums;
    struct Entered {
        WaveCell part;
        double start;
    };
    std::optional<Entered> m_entered;
};

/// What moves at one time, all over the string. Units of Problem.
struct CensusResult {
    double time = 0;
    BitNodeState bit = {};
    FaceNodeState face = {};
    double hammerMomentum = 0, hammerEnergy = 0;
    double stringMomentum = 0, stringEnergy = 0;
    double jointLoss = 0, rodLoss = 0, externalMomentum = 0;
    double faceEnergy = 0;
};

}  // namespace drillwave
