// SPDX-License-Identifier: GPL-3.0-or-later
// A blow as the window needs it: requested once, solved once, shared by all pages that show it.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <typeinfo>
#include <vector>

#include "core/blow/blow.h"
#include "core/study/drilling/drilling_case.h"
#include "ui/text/shown_units.h"

namespace drillwave {

class LocalStyle;
struct SolvedBlow;

// Data that a page shows beside the blow itself: only the page knows their type, the job carries them.

/// A value of a page's own type, made on the job's thread and never changed once made.
class PageData {
  public:
    PageData() = default;
    template <class Value>
    static PageData of(Value value) {
        return {std::make_shared<const Value>(std::move(value)), &typeid(Value)};
    }

    /// nullptr when it is of another type: another page's.
    template <class Value>
    const Value* as() const {
        return m_type && *m_type == typeid(Value) ? static_cast<const Value*>(m_value.get()) : nullptr;
    }

  private:
    PageData(std::shared_ptr<const void> value, const std::type_info* type)
        : m_value(std::move(value)), m_type(type) {}

    std::shared_ptr<const void> m_value;
    const std::type_info* m_type = nullptr;
};

/// Makes the data of a page from a solved blow. Called on the job's thread: it holds all that it needs by
/// value. Long work ends early, with anything, when the blow's `request.stop` requires it.
using PreparePage = std::function<PageData(const SolvedBlow& blow)>;

/// A blow of a march under the feed.
struct MarchedQuestion {
    DrillingSettings settings;
    long number = 1;  ///< from 1
    bool operator==(const MarchedQuestion&) const = default;
};

/// Input of a solver job. Visible pages pass a function that makes their data; hidden pages do not.
struct SolveRequest {
    Scenario scenario;
    UnitSystem units = UnitSystem::dimensionless;
    ChosenUnits chosenUnits = {};               ///< of kinds that do not follow `units`
    UnitSystem physicalUnits = UnitSystem::si;  ///< SI or US: of sentences, also where `units` are none
    std::vector<PreparePage> pages;
    std::uint64_t number = 0;   ///< counts requests: identifies the answer to the last question
    std::stop_token stop = {};  ///< ends the work early, with a problem for an answer
    /// For drill strings that take 0.1 s or more to solve: a first answer with a larger error.
    bool quick = false;
    /// Shows this one of the scenario's many blows instead of its single blow.
    std::optional<MarchedQuestion> marched = {};
};

/// The answer, never changed once made: the blow, and the data of the pages. `fault` is empty when the blow
/// was solved; otherwise it is a sentence with the reason, and the numbers must not be used.
struct SolvedBlow : Blow {
    /// The requested one of many blows, with the pages.
    std::shared_ptr<const SolvedBlow> marchedBlow;
    SolveRequest request;  ///< its `pages` and `stop` are there only while it is being answered
    QString fault;
    ShownUnits units;
    std::vector<PageData> pages;  ///< one for each of the request's that was not empty

    /// Returns the data of a page; nullptr if it has none, or there is no blow.
    template <class Value>
    const Value* page() const {
        for (const PageData& data : pages)
            if (const Value* value = data.as<Value>()) return value;
        return nullptr;
    }
};
using SolvedBlowPtr = std::shared_ptr<const SolvedBlow>;

/// Returns the style of sentences about the answer.
LocalStyle styleOf(const SolveRequest& request);

/// Solves and prepares a request; reuses the march of `before` if it has the requested one of many blows.
/// Never throws: any error is the answer's `fault`.
SolvedBlowPtr solveBlow(const SolveRequest& request, MethodSolver& solver,
                        const SolvedBlow* before = nullptr) noexcept;

/// Returns an answer with only the reason of a failure.
SolvedBlowPtr failedBlow(const SolveRequest& request, const QString& problem);

// Results that take a while are solved once, however often pages look at them.

/// Whether a blow answers a request except for its units and pages, and is worth reusing: only for drill
/// strings, as a rod is solved sooner than its histories are copied.
bool answersAgain(const SolvedBlow& before, const SolveRequest& request);

/// Returns the earlier blow with the units and the pages of the request; otherwise as solveBlow().
SolvedBlowPtr answerAgain(const SolvedBlow& before, const SolveRequest& request) noexcept;

}  // namespace drillwave
