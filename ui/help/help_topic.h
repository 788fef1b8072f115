// SPDX-License-Identifier: GPL-3.0-or-later
// Places in the manual, links to them, and the place that describes a widget.
#pragma once

#include <QString>
#include <QUrl>

class QWidget;

namespace drillwave {

// Types and functions for a place in the manual and links to it.

/// Place in the manual: a chapter, and a heading or equation in it. `heading` is a section's number "§3.1",
/// its words or the first of them, or an equation, "(T34)". Empty means the start of the chapter.
struct ManualPlace {
    QString chapter;
    QString heading = {};
    bool operator==(const ManualPlace&) const = default;
};

/// Returns the link to a place, "manual:theory#§3".
QUrl urlOf(const ManualPlace& place);
/// Returns the place to which a link leads; the chapter is empty for links outside the manual.
ManualPlace placeOf(const QUrl& url);

/// Regular expression for "and" in the languages of the manual.
inline constexpr char16_t andWords[] = u"(?:and|und|och)";

/// Returns true if `meant`, a heading as written in a link, refers to the heading `shown`. For example, "§4.2
/// sweep and table" is meant by "§4.2" and by "table", and "rod.length: length L" by "rod.length".
bool isHeading(const QString& shown, const QString& meant);

/// Name of the widget property that contains the place in the manual, "window §2", which describes everything
/// inside the widget.
inline constexpr char helpTopicProperty[] = "helpTopic";

/// Returns the place in the manual that describes the parameter with this key; the chapter is empty for other
/// keys.
ManualPlace placeOfKey(const QString& key);

/// Returns the place in the manual that describes the focused widget, or its nearest parent with one. The
/// chapter is empty if there is none. Fields have the key of their parameter as object name, sliders the key
/// and ".slider".
ManualPlace topicOf(const QWidget* focus);

}  // namespace drillwave
