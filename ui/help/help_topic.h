// SPDX-License-Identifier: GPL-3.0-or-later
// Places in the manual, links to them, and the place that describes a widget.
#pragma once

#include <QString>
#include <QUrl>

class QWidget;

namespace drillwave {

// Types and functions for a place in the manual and links to it.

/// Place in the manual: a chapter, and a heading or equation in it. `heading` is the number of a section
/// ("§3.1"), its words or the first of them, or the number of an equation ("(T34)"). If it is empty, the
/// place is the start of the chapter.
struct ManualPlace {
    QString chapter;
    QString heading = {};
    bool operator==(const ManualPlace&) const = default;
};

/// Returns the link to a place in the manual, such as "manual:theory#§3".
QUrl urlOf(const ManualPlace& place);
/// Returns the place to which a link leads; the chapter is empty for links outside the manual.
ManualPlace placeOf(const QUrl& url);

/// Regular expression for the word "and" in the languages of the manual. It separates names in a heading,
/// such as "sweep and table".
inline constexpr char16_t andWords[] = u"(?:and|und|och)";

/// Returns true if `meant`, a heading as written in a link, refers to the heading `shown`. For example, "§4.2
/// sweep and table" is meant by "§4.2" and by "table", and "rod.length: length L" by "rod.length".
bool isHeading(const QString& shown, const QString& meant);

/// Name of a Qt property of widgets. Its value is the place in the manual that describes everything inside
/// the widget, such as "window §2".
inline constexpr char helpTopicProperty[] = "helpTopic";

/// Returns the place in the manual that describes the parameter with this key; the chapter is empty for other
/// keys.
ManualPlace placeOfKey(const QString& key);

/// Returns the place in the manual that describes the focused widget, or its nearest parent with one. The
/// chapter is empty if there is none. Fields have the key of their parameter as object name, sliders the key
/// and ".slider".
ManualPlace topicOf(const QWidget* focus);

}  // namespace drillwave
