// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_topic.h"

#include <QRegularExpression>
#include <QVariant>
#include <QWidget>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_field.h"

namespace drillwave {

namespace {

const QString scheme = QStringLiteral("manual");

QString fromKey(std::string_view key) {
    return QString::fromUtf8(key.data(), qsizetype(key.size()));
}

}  // namespace

QUrl urlOf(const ManualPlace& place) {
    QUrl url;
    url.setScheme(scheme);
    url.setPath(place.chapter);
    if (!place.heading.isEmpty()) url.setFragment(place.heading);
    return url;
}

ManualPlace placeOf(const QUrl& url) {
    if (url.scheme() != scheme) return {};
    return {url.path(), url.fragment(QUrl::FullyDecoded)};
}

bool isHeading(const QString& shown, const QString& meant) {
    if (shown == meant || shown.startsWith(meant + u' ') || shown.startsWith(meant + u':')) return true;
    static const QRegularExpression number(QStringLiteral("^§[0-9.]+ ")),
        between(QStringLiteral(", | %1 ").arg(QStringView(andWords)));
    return QString(shown).remove(number).split(between).contains(meant);
}

// Numbers of sections, and of corners, have one entry for all of them.
ManualPlace placeOfKey(const QString& key) {
    const QString chapter = QStringLiteral("parameters");
    const std::string name = key.toStdString();
    if (findWordParameter(name) || name == restrikeKey) return {chapter, key};
    const KeptParameter parameter = findParameter(name);
    if (!parameter) return {};
    if (parameter->address)
        return {chapter, QStringLiteral("string.NAME.") + fromKey(parameter->address->field->key)};
    if (cornerOf(*parameter) > 0)
        return {chapter, QString::fromStdString(cornerKey(1, name.substr(name.rfind('.') + 1)))};
    return {chapter, key};
}

ManualPlace topicOf(const QWidget* focus) {
    for (const QWidget* each = focus; each; each = each->parentWidget()) {
        const QString said = each->property(helpTopicProperty).toString();
        if (!said.isEmpty()) return {said.section(u' ', 0, 0), said.section(u' ', 1)};
        const QString name = each->objectName();
        const ManualPlace place =
            placeOfKey(name.endsWith(QStringLiteral(".slider")) ? name.chopped(7) : name);
        if (!place.chapter.isEmpty()) return place;
    }
    return {};
}

}  // namespace drillwave
