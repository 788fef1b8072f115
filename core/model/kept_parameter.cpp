// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/kept_parameter.h"

#include <cassert>
#include <utility>

#include "core/model/section_parameter.h"

namespace drillwave {

KeptParameter::KeptParameter(const Parameter& parameter)
    : KeptParameter(parameter.address ? findSectionParameter(parameter.key)
                                      : KeptParameter(std::shared_ptr<const Parameter>(
                                            std::shared_ptr<void>(), &parameter))) {}

KeptParameter::KeptParameter(std::shared_ptr<const Parameter> parameter)
    : m_parameter(std::move(parameter)) {}

const Parameter& KeptParameter::operator*() const {
    assert(m_parameter);
    return *m_parameter;
}

bool operator==(const KeptParameter& one, const KeptParameter& other) {
    if (!one || !other) return !one && !other;
    return one.m_parameter == other.m_parameter || one->key == other->key;
}

}  // namespace drillwave
