// SPDX-License-Identifier: GPL-3.0-or-later
// State of the march along the front end of the rod between events, and its steps: only the class, without
// the parts it uses.
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

namespace drillwave {

// The waves inside the rod: the incident wave of the next round trip, as a queue of pieces.

/// First-in first-out ring of pieces that keeps its memory between solves. Index 0 is the next to arrive.
/// The ring is of places: free flight sends long pieces round and round.
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

    /// The piece that was taken last: it stays until the next is, whatever is put in.
    Piece& taken() { return *m_taken; }
    /// Takes the front piece out.
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
    /// A new last piece, to be assigned: it holds what an earlier one has left.
    Piece& pushBack() {
        if (m_size == m_ring.size()) grow();
        ++m_size;
        return back();
    }
    /// The first `count` pieces have arrived and leave again unchanged (free reflection at both ends).
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
    std::vector<Piece*> m_ring;  ///< all others
    std::size_t m_head = 0;
    std::size_t m_size = 0;
    std::size_t m_mask = 0;
};

/// Limits of the work of a march, and of its duration.
struct MarchLimits {
    long pieces = 30'000'000;               ///< smooth pieces
    const std::stop_token* stop = nullptr;  ///< none: to the end
    InputMove move = {};
    /// Receives the recorded histories whenever they have as many pieces as it returned before (or
    /// piecesHandedOver), so that their length is unlimited; may be nullptr.
    const HandOver* handOver = nullptr;
    bool ledger = true;  ///< whether to sum up for Detail::ledger, if as much detail is requested
    /// Largest useful error of e: a march with a larger one is given up.
    double error = std::numeric_limits<double>::infinity();
};

/// Solves, piece by piece,
///     g(s) = Fa(s) + g(s − 2τ) − F(s − 2τ)         [paper (6)]
///     F' = a(2g − F),  a = β, s_j β behind a corner, β/γ or 0             [paper (5)] [paper (8)]
///
/// `Basis` represents functions on an interval: it solves one piece of contact exactly, finds first zeros,
/// and cuts and integrates pieces. Basis::failed() reports what it cannot represent.
template <class Basis>
class ContactMarch {
  public:
    using Real = typename Basis::Real;
    using Piece = typename Basis::Piece;

    /// Solves into `impact`. False when the basis cannot represent this blow to full accuracy.
    /// More pieces than permitted, and a stop, end as Outcome::notSolved.
    bool solve(const Problem& problem, Detail detail, Impact& impact, const MarchLimits& limits = {});

  private:
    enum class Progress { goesOn, finished };
    enum class Ending { none, separation, unloading, primaryLoading, corner };
    struct Stretch {
        Real length;
        Ending ending;
    };
    /// Returns the event that is recorded for an ending; not for `none`.
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

    /// Layers thinner than this are below the rounding of time; taking them so thick moves e by less than
    /// 1e-13.
    static constexpr Real fastestRate = Real(1e15);

    /// After this many events in a row without progress in time the branch is taken to hang on rounding;
    /// after the second number nothing more is asked.
    static constexpr int repeatedEvents = 3, mostEventsOnTheSpot = 6;

    /// A gap that opens no further than the rounding of the distance travelled is none.
    static constexpr Real closedGap = 8 * std::numeric_limits<Real>::epsilon();

    /// Impact::energyResidual() is 4e-10 at most, where pieces of wave are joined; a force that changes from
    /// line to line of the law where these do not meet misses 1e-3 and more.
    static constexpr double mostMissingEnergy = 1e-6;

    /// How often to look for a stop: every millisecond or so.
    static constexpr long piecesBetweenLooks = 8192;

    static constexpr Real never = std::numeric_limits<Real>::infinity();

    static constexpr std::size_t mostWaiting = 400'000;
    /// 0.9 kB each while they grow: some 3.6 GB.
    static constexpr long mostRecordedPieces = 4'000'000;

    void begin(const Problem& problem, Detail detail, Impact& impact);
    bool march();
    Piece& incident() { return m_waves.taken(); }  ///< g now arriving
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
    /// By how much the momentum of the rod may be wrong, on the safe side of a proof.
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
    /// Whether the work must end, and why; cheap enough for every piece.
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

    /// Fails with an order of events that the basis cannot decide; returns false.
    bool undecided() {
        fail(translatable("the order of two events hangs on rounding"));
        return false;
    }

    bool failAtLimit() {
        const bool atMemory = m_mostPieces < m_limits.pieces;
        fail(atMemory
                 ? translatable("its histories need more than 4 million wave pieces, because of very many "
                                "reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer")
                 : translatable(
                       "its waves have more polynomial pieces (wave pieces) than permitted, because of very "
                       "many reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer"));
        m_impact->hindrance = atMemory ? Hindrance::histories : Hindrance::workLimit;
        return true;
    }

    Basis m_basis;
    WaveQueue<Piece> m_waves;  ///< g of the next round trip without Fa
    const PulseForce* m_pulse = nullptr;
    Impact* m_impact = nullptr;
    MarchLimits m_limits;
    long m_mostPieces = 0;
    std::size_t m_nextHandOver = 0;
    long m_nextLook = 0;  ///< how many pieces may pass before lookForEnd()
    Detail m_detail = Detail::cor;

    ContactLaw<Real> m_law{1, 1};  ///< with the memory of the rock
    Real m_roundTrip = 0;
    Real m_arrival = 0;                 ///< global time of s = 0
    typename Basis::Sum m_s;            ///< time at the front end
    CompensatedSum<Real> m_hammerTime;  ///< how far the hammer force has been used
    std::size_t m_hammerPiece = 0;
    bool m_everTouched = false;
    bool m_touching = false;  ///< apart, but by zero: forceless contact
    bool m_justUnloaded = false;
    int m_eventsOnTheSpot = 0;                ///< events in a row without progress in time
    ContactLine m_line = ContactLine::apart;  ///< apart, with a zero gap: also forceless contact
    Real m_periodsAhead = 0;                  ///< periods of free flight still to come before `m_gap` counts
    CompensatedSum<Real> m_gap;               ///< distance still to close, displacement unit I0/Z
    Real m_gapError = 0;                      ///< of it, in e, once it closes
    Real m_nextProof = never;                 ///< time of the next look whether the rod stays away
    Real m_opened = 0;                        ///< largest gap since the last separation
    double m_separatedBefore = 0;             ///< time of the separation before the last one
    Real m_force = 0;
    Real m_closingSpeed = 0;  ///< of the bit at the last contact, force unit; 0 for the first contact
    Real m_contactForce = 0;  ///< largest force since then, at the ends of pieces
    Real m_growth = 1;        ///< Impact::growth
    typename Basis::Sum m_contactTime;  ///< summed over contacts
    typename Basis::Sum m_impulse;
    Real m_error = 0;
};

}  // namespace drillwave
