// SPDX-License-Identifier: GPL-3.0-or-later
// Result for one blow, solved once and shared by all pages of the window.
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

// Data that a page shows beside the blow. Only the page knows their type.

/// Data of any type that a page of the window shows. They are made in the solver's thread and do not change
/// afterwards.
class PageData {
  public:
    PageData() = default;
    template <class Value>
    static PageData of(Value value) {
        return {std::make_shared<const Value>(std::move(value)), &typeid(Value)};
    }

    /// Returns the data if they are of the type Value. Otherwise they belong to another page, and nullptr is
    /// returned.
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

/// Function of a page that makes its data from a solved blow, in the solver's thread. It must own copies of
/// all its inputs. It should end early, with any result, when the blow's `request.stop` is set.
using PreparePage = std::function<PageData(const SolvedBlow& blow)>;

/// Request for one blow out of a computed sequence of many blows.
struct MarchedQuestion {
    DrillingSettings settings;
    long number = 1;  ///< number of the blow in the sequence, counted from 1
    bool operator==(const MarchedQuestion&) const = default;
};

/// Request to solve a blow. Each visible page adds a function to `pages` that makes its data; hidden pages do
/// not.
struct SolveRequest {
    Scenario scenario;
    UnitSystem units = UnitSystem::dimensionless;
    ChosenUnits chosenUnits = {};  ///< units chosen for individual kinds of quantity, which override `units`
    UnitSystem physicalUnits = UnitSystem::si;  ///< units in sentences, even if `units` are dimensionless
    std::vector<PreparePage> pages;
    std::uint64_t number = 0;   ///< number of the request, which identifies its answer
    std::stop_token stop = {};  ///< ends the work early; the answer then has a `fault`
    /// Whether a first answer with a larger error is requested. This is meant for drill strings that take 0.1
    /// s or more to solve.
    bool quick = false;
    /// Blow of a sequence of many blows to show instead of the single blow; nothing for the single blow.
    std::optional<MarchedQuestion> marched = {};
};

/// Answer to a SolveRequest: the blow and the data of the pages; it never changes. `fault` is empty if the
/// blow was solved. Otherwise it is a sentence with the reason, and the numbers must not be used.
struct SolvedBlow : Blow {
    /// Requested blow out of a sequence of many blows, with the data of the pages; nullptr for a single blow.
    std::shared_ptr<const SolvedBlow> marchedBlow;
    SolveRequest request;  ///< request of this answer; `pages` and `stop` are cleared once it is answered
    QString fault;
    ShownUnits units;
    std::vector<PageData> pages;  ///< data of the pages, one for each function in the request

    /// Returns the data of the type Value that a page has added; nullptr if there are none or the blow was
    /// not solved.
    template <class Value>
    const Value* page() const {
        for (const PageData& data : pages)
            if (const Value* value = data.as<Value>()) return value;
        return nullptr;
    }
};
using SolvedBlowPtr = std::shared_ptr<const SolvedBlow>;

/// Returns the style (language, number format, units) of sentences about the answer to a request.
LocalStyle styleOf(const SolveRequest& request);

/// Solves a request and makes the data of the visible pages. If the earlier answer `before` contains the
/// requested blow of a sequence, that blow is reused. Never throws: an error becomes the `fault` of the
/// answer.
SolvedBlowPtr solveBlow(const SolveRequest& request, MethodSolver& solver,
                        const SolvedBlow* before = nullptr) noexcept;

/// Returns an answer to a request that failed, with the reason as its `fault`.
SolvedBlowPtr failedBlow(const SolveRequest& request, const QString& problem);

// Results of long computations are reused when only units or pages change.

/// Returns true if `before` also answers `request`, except for units and page data, so that the blow need not
/// be solved again. Always false for uniform rods, because solving them is faster than copying a result.
bool answersAgain(const SolvedBlow& before, const SolveRequest& request);

/// Returns the blow of an earlier answer, with the units and page data of the new request. Requires that
/// answersAgain() returns true.
SolvedBlowPtr answerAgain(const SolvedBlow& before, const SolveRequest& request) noexcept;

}  // namespace drillwave
