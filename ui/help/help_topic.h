// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the manual it stands what a widget is about.
#pragma once

#include "ui/help/manual_place.h"

class QWidget;

namespace drillwave {

/// A property of a widget that says "window §2" of all that is inside it.
inline constexpr char helpTopicProperty[] = "helpTopic";

/// Where the parameter of a key is told; no chapter where it is no key.
ManualPlace placeOfKey(const QString& key);

/// Of the widget that has the focus, or of what it stands in: a field is called by the key of its parameter,
/// its slider likewise with ".slider" behind. No chapter where nothing of it says where.
ManualPlace topicOf(const QWidget* focus);

}  // namespace drillwave
