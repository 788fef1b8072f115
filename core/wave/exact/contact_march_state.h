// SPDX-License-Identifier: GPL-3.0-or-later
// Class ContactMarch: state of the solution from event to event at the front end of the rod. Its functions
// are defined in contact_march.h and the files included there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/contact/contact_law.h"
#include "core/model/pulse_force.h"
#include "core/model/scenario.h"
#include "core/numeric/compensated_sum.h"
#include "core/text/message.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/exact/input_move.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"
#include "core/wave/work_limit.h"

namespace drillwave {

// Waves inside the rod: the incident wave of the next round trip, as a queue of smooth pieces

/// First-in first-out queue of pieces of a wave, which keeps its memory between solutions. Index 0 is the
/// piece that arrives next. It is a ring of pointers, so that moving a long piece from the front to the back
/// is cheap.
template <class Piece>
class WaveQueue {
  public:
    WaveQueue() = default;
    WaveQueue(const WaveQueue&) = delete;
    WaveQueue& operator=(const WaveQueue&) = delete;

    void clear() {
        m_head = 0;
        m_size = 0;
    }
    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }

    Piece& operator[](std::size_t i) { return *m_ring[(m_head + i) & m_mask]; }
    const Piece& operator[](std::size_t i) const { return *m_ring[(m_head + i) & m_mask]; }
    Piece& front() { return *m_ring[m_head]; }
    Piece& back() { return (*this)[m_size - 1]; }

    /// Returns the piece that take() removed last. It stays valid until the next call of take(), even if
    /// pieces are added.
    Piece& taken() { return *m_taken; }
    /// Removes the front piece from the queue and returns it.
    Piece& take() {
        std::swap(m_taken, m_ring[m_head]);
        popFront();
        return *m_taken;
    }
    void popFront() {
        m_head = (m_head + 1) & m_mask;
        --m_size;
    }
    void popBack() { --m_size; }
    void pushBack(const Piece& piece) { pushBack() = piece; }
    /// Adds a piece at the back of the queue and returns it for writing. Until it is written, it has the
    /// content of an earlier piece.
    Piece& pushBack() {
        if (m_size == m_ring.size()) grow();
        ++m_size;
        return back();
    }
    /// Moves the first `count` pieces of the wave to the back of the queue, in order. This is what happens
    /// without contact: both free ends of the rod reflect the wave, and it returns unchanged.
    void rotate(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            std::swap(m_ring[m_head], m_ring[(m_head + m_size) & m_mask]);
            m_head = (m_head + 1) & m_mask;
        }
    }

  private:
    void grow() {
        const std::size_t size = m_ring.empty() ? 64 : 2 * m_ring.size();
        std::vector<Piece*> ring;
        ring.reserve(size);
        for (std::size_t i = 0; i < m_size; ++i) ring.push_back(&(*this)[i]);
        while (ring.size() < size) ring.push_back(&m_pieces.emplace_back());
        m_ring = std::move(ring);
        m_head = 0;
        m_mask = size - 1;
    }

    std::deque<Piece> m_pieces{1};
    Piece* m_taken = &m_pieces.front();
    std::vector<Piece*> m_ring;  ///< all pieces except m_taken
    std::size_t m_head = 0;
    std::size_t m_size = 0;
    std::size_t m_mask = 0;
};

/// Limits for the work of an exact solution, and options for what it records.
struct MarchLimits {
    /// Maximum number of smooth pieces into which the waves of one blow are divided; a blow that needs more
    /// is not solved.
    long pieces = 30'000'000;
    /// Source of stop requests; null if there is none.
    const std::stop_token* stop = nullptr;
    /// Change of the input by a few units of rounding, to estimate the sensitivity of the result.
    InputMove move = {};
    /// Function that receives the recorded histories in parts, so that they need not fit in memory; null if
    /// not used. It is called when piecesHandedOver pieces are recorded. Each call returns the number of
    /// pieces at which it is called again.
    const HandOver* handOver = nullptr;
    /// Whether the sums of Detail::ledger (momentum and energy of the waves) are computed, if that detail is
    /// requested.
    bool ledger = true;
    /// Largest permitted error of the coefficient of restitution. The computation stops as soon as its error
    /// exceeds this value, and the blow is not solved.
    double error = std::numeric_limits<double>::infinity();
};

/// Solver for the impact force F of one blow, with the hammer force Fa on a uniform rod. It follows the
/// incident wave g at the bit, one smooth piece of the wave after another:
///
///     g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ)         [paper (6)]
///
///     F' = a(2g − F),  a = β, s_j β after a corner, β/γ or 0              [paper (5)] [paper (8)]
///
/// The rate a is the slope of the present line of the bit–rock law, or 0 while bit and rock are apart.
/// `Basis` is the representation of wave pieces: exponential sums or power series. It solves the second
/// equation over one piece, finds zeros, cuts and integrates. Basis::failed() reports a function that it
/// cannot represent.
template <class Basis>
class ContactMarch {
  public:
    using Real = typename Basis::Real;
    using Piece = typename Basis::Piece;

    /// Solves the blow and writes the result into `impact`. Returns false if `Basis` cannot represent its
    /// waves to full accuracy; the result is then invalid. Too many wave pieces or a stop request give
    /// Outcome::notSolved.
    bool solve(const Problem& problem, Detail detail, Impact& impact, const MarchLimits& limits = {});

  private:
    enum class Progress { goesOn, finished };
    enum class Ending { none, separation, unloading, primaryLoading, corner };
    struct Stretch {
        Real length;
        Ending ending;
    };
    /// Returns the contact event to record when a stretch of contact ends in the way `ending`. Requires an
    /// `ending` other than `none`.
    static ContactEvent eventOf(Ending ending) {
        switch (ending) {
            case Ending::none:
            case Ending::separation:
                break;
            case Ending::unloading:
                return ContactEvent::unloading;
            case Ending::primaryLoading:
                return ContactEvent::primaryLoading;
            case Ending::corner:
                return ContactEvent::corner;
        }
        return ContactEvent::separation;
    }
    using Response = typename Basis::Response;

    /// Upper limit of the rate a [1/t0] in F' = a(2g − F); larger rates are replaced by it. At this rate, the
    /// force follows the wave within the rounding of time. The limit changes the coefficient of restitution
    /// by less than 1e-13.
    static constexpr Real fastestRate = Real(1e15);

    /// Limits of the number of contact events in a row at the same time. Above repeatedEvents, mayStay()
    /// checks whether only rounding makes the force change between lines of the law; it then stays on its
    /// line. Above mostEventsOnTheSpot, it stays without a check.
    static constexpr int repeatedEvents = 3, mostEventsOnTheSpot = 6;

    /// Largest gap, in units of I0/Z, that counts as rounding of the distance travelled, not as a separation.
    static constexpr Real closedGap = 8 * std::numeric_limits<Real>::epsilon();

    /// Largest relative error of the energy balance (Impact::energyResidual()) of a valid result. Correct
    /// solutions have at most 4e-10. If the force changes between lines of the bit–rock law where they do not
    /// meet, it is 1e-3 or more.
    static constexpr double mostMissingEnergy = 1e-6;

    /// Number of computed pieces between two checks for a stop request; they take about one millisecond.
    static constexpr long piecesBetweenLooks = 8192;

    static constexpr Real never = std::numeric_limits<Real>::infinity();

    static constexpr std::size_t mostWaiting = 400'000;
    /// Maximum number of wave pieces in the recorded histories. Each takes 0.9 kB while the recording grows,
    /// 3.6 GB in all.
    static constexpr long mostRecordedPieces = 4'000'000;

    void begin(const Problem& problem, Detail detail, Impact& impact);
    bool march();
    /// Returns the piece of the incident wave g that is arriving at the front end now.
    Piece& incident() { return m_waves.taken(); }
    bool isSliver(const Piece& piece);
    void nextArrival();
    Real hammerWork(const PulseSegment& segment, Real into, Real length);
    void advanceApart();
    Stretch firstEvent(Response& response);
    bool mayStay(const Response& response);
    void countJoining(const Response& response, Real length, Ending ending);
    void advanceContact();
    void changeBranch(Ending ending, Real length);
    bool hammerHasEnded() const { return m_hammerPiece >= m_pulse->segments.size(); }
    /// Returns a safe upper bound of the error of the rod's momentum, in units of I0: four times the sum of
    /// the estimated errors. Proofs that no contact follows use it.
    Real uncertainMomentum() const { return 4 * (m_error + m_gapError + m_basis.momentumNoise()); }
    bool staysAway();
    Progress flyFree();
    Progress skipPeriods(Real momentum);
    void passPeriods(Real periods);
    void closeGap(const Piece& arriving, Real length);
    void drift(const Piece& arriving, Real impulse);
    void separate();
    void rejoin();
    void pass(const Piece& incident, const Piece* force, Real length);
    void leaveFree(Real length);
    void joinLast();
    [[gnu::always_inline]] inline void leaveContact(Response& response, Real length);
    void finish();
    void summarise();
    void note(ContactEvent kind) {
        if (m_detail >= Detail::events) m_impact->events.push_back({kind, double(m_arrival + m_s)});
    }
    /// Returns whether the solution must end now, because of the work limit, too large an error, or a stop
    /// request. The blow is then marked as not solved. The check is cheap enough for every piece.
    bool isOver() {
        if (m_waves.size() > mostWaiting) return failAtLimit();
        if (m_error > m_limits.error) return fail(translatable("its error would be larger than permitted"));
        return m_impact->pieces > m_nextLook && lookForEnd();
    }
    bool lookForEnd() {
        if (m_impact->pieces > m_mostPieces) return failAtLimit();
        if (m_limits.stop && m_limits.stop->stop_requested()) return fail("stopped");
        m_nextLook = std::min(m_mostPieces, m_impact->pieces + piecesBetweenLooks);
        return false;
    }
    bool fail(const char* reason) {
        m_impact->outcome = Outcome::notSolved;
        m_impact->reason = reason;
        return true;
    }

    /// Marks the blow as not solved because the order of two contact events depends on rounding; returns
    /// false.
    bool undecided() {
        fail(translatable("the order of two events hangs on rounding"));
        return false;
    }

    bool failAtLimit() {
        const bool atMemory = m_mostPieces < m_limits.pieces;
        fail(atMemory ? translatable(
                            "its histories have more than 4 million polynomial pieces, because of very many "
                            "reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer")
                      : WorkLimitReason::pieces);
        m_impact->hindrance = atMemory ? Hindrance::histories : Hindrance::workLimit;
        return true;
    }

    Basis m_basis;
    /// Incident wave g of the next round trip at the front end, without the hammer force Fa that is still to
    /// be added.
    WaveQueue<Piece> m_waves;
    const PulseForce* m_pulse = nullptr;
    Impact* m_impact = nullptr;
    MarchLimits m_limits;
    long m_mostPieces = 0;
    std::size_t m_nextHandOver = 0;
    /// Number of computed wave pieces at which the work limit and stop requests are checked next.
    long m_nextLook = 0;
    Detail m_detail = Detail::cor;

    /// Bit–rock law with its memory, the largest force so far.
    ContactLaw<Real> m_law{1, 1};
    Real m_roundTrip = 0;
    /// Time t/t0 since the start of the blow at which the first wave reaches the bit. The time s is counted
    /// from there.
    Real m_arrival = 0;
    typename Basis::Sum m_s;  ///< present time s/t0 at the front end
    /// Time up to which the hammer force has been added to the waves, in units of t0.
    CompensatedSum<Real> m_hammerTime;
    std::size_t m_hammerPiece = 0;
    bool m_everTouched = false;
    /// Whether bit and rock touch although the contact force is zero and m_line is `apart`.
    bool m_touching = false;
    bool m_justUnloaded = false;
    /// Number of contact events in a row at the same time.
    int m_eventsOnTheSpot = 0;
    /// Line of the bit–rock law on which the contact is now; `apart` also for contact without force.
    ContactLine m_line = ContactLine::apart;
    /// Number of whole round trips of free flight before the gap m_gap starts to close.
    Real m_periodsAhead = 0;
    /// Gap between bit and rock that is left after m_periodsAhead, in units of I0/Z.
    CompensatedSum<Real> m_gap;
    /// Error of the coefficient of restitution due to the rounding of m_gap. It is added to m_error when the
    /// gap closes.
    Real m_gapError = 0;
    /// Time s/t0 at which it is next checked whether the rod certainly stays away from the rock.
    Real m_nextProof = never;
    /// Largest gap between bit and rock since the last separation, in units of I0/Z.
    Real m_opened = 0;
    /// Time t/t0 of the separation before the last one. It is restored if the last one turns out to be
    /// rounding.
    double m_separatedBefore = 0;
    Real m_force = 0;
    /// Velocity of the bit towards the rock when the last contact began, in units of F0/Z; 0 for the first
    /// contact.
    Real m_closingSpeed = 0;
    /// Largest impact force since the last contact began, taken only at the ends of wave pieces, in units of
    /// F0.
    Real m_contactForce = 0;
    /// Factor by which rounding errors have been amplified so far (Impact::growth).
    Real m_growth = 1;
    /// Sum of the durations of all contacts, in units of t0.
    typename Basis::Sum m_contactTime;
    typename Basis::Sum m_impulse;
    Real m_error = 0;
};

}  // namespace drillwave
