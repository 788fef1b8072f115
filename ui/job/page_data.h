// SPDX-License-Identifier: GPL-3.0-or-later
// What a page shows of a blow beside the blow itself: known to the page alone, carried by the job.
#pragma once

#include <functional>
#include <memory>
#include <typeinfo>

namespace drillwave {

struct SolvedBlow;

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

/// From a solved blow to what a page shows of it. Called on the job's thread: it holds all that it needs by
/// value. Long work ends early, with anything, when the blow's `request.stop` asks for it.
using PreparePage = std::function<PageData(const SolvedBlow& blow)>;

}  // namespace drillwave
