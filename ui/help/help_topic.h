// SPDX-License-Identifier: GPL-3.0-or-later
// Place of a widget's subject in the manual.
#pragma once

#include <QString>
#include <QUrl>

class QWidget;

namespace drillwave {

// A place in the manual, and links to it.

/// A chapter and a heading in it: its number "§3.1", its words, or the first of them; or an equation,
/// "(T34)". Without a heading the chapter's beginning.
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

/// Whether a heading as shown is the one meant: "§4.2 sweep and table" by "§4.2" and by "table", "rod.length:
/// length L" by "rod.length".
bool isHeading(const QString& shown, const QString& meant);

/// A property of a widget with the topic, "window §2", of all that is inside it.
inline constexpr char helpTopicProperty[] = "helpTopic";

/// Returns where the manual describes the parameter of a key; no chapter for other keys.
ManualPlace placeOfKey(const QString& key);

/// Returns the topic of the focused widget or of its nearest parent with one. Fields are named by the key of
/// their parameter, sliders by the key with ".slider" appended. No chapter if there is none.
ManualPlace topicOf(const QWidget* focus);

}  // namespace drillwave
