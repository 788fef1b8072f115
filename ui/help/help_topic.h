// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the manual it stands what a widget is about.
#pragma once

#include <QString>
#include <QUrl>

class QWidget;

namespace drillwave {

// A place in the manual, and links to it.

/// A chapter, and in it what a heading says: its number "§3.1", its words, or the first of them; or an
/// equation, "(T34)". Without one the chapter's beginning.
struct ManualPlace {
    QString chapter;
    QString heading = {};
    bool operator==(const ManualPlace&) const = default;
};

/// "manual:theory#§3".
QUrl urlOf(const ManualPlace& place);
/// No chapter where it is no such link.
ManualPlace placeOf(const QUrl& url);

/// "and", as the languages of the manual have it, in a regular expression.
inline constexpr char16_t andWords[] = u"(?:and|und|och)";

/// Whether a heading, as it is shown, is the one that is meant: "§4.2 sweep and table" by "§4.2" and by
/// "table", "rod.length: length L" by "rod.length".
bool isHeading(const QString& shown, const QString& meant);

/// A property of a widget that says "window §2" of all that is inside it.
inline constexpr char helpTopicProperty[] = "helpTopic";

/// Returns where the manual describes the parameter of a key; no chapter for other keys.
ManualPlace placeOfKey(const QString& key);

/// Returns the topic of the focused widget or of its nearest parent with one. Fields are named by the key of
/// their parameter, sliders by the key with ".slider" appended. No chapter if there is none.
ManualPlace topicOf(const QWidget* focus);

}  // namespace drillwave
