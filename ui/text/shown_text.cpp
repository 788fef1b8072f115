// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTextDocument>
#include <string>
#include <utility>

#include "core/report/parameter_words.h"
#include "core/text/name_text.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {

namespace {

Message titleOf(const Parameter& parameter) {
    return titleMessage(parameter, shownSymbol(parameter.symbol).toStdString());
}

}  // namespace

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave", text);
}

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString withoutMarkup(const QString& text) {
    const QString printable = QString::fromStdString(printableLines(text.toStdString()));
    return Qt::mightBeRichText(printable) ? Qt::convertFromPlainText(printable) : printable;
}

QString withSigns(QString text) {
    static const std::pair<QRegularExpression, QString> signs[] = {
        {QRegularExpression(QStringLiteral("\\b([IFWdtk])0\\b")), QStringLiteral("\\1₀")},
        {QRegularExpression(QStringLiteral("\\+-")), QStringLiteral("±")},
        {QRegularExpression(QStringLiteral("\\bphi\\b")), QStringLiteral("φ")}};
    for (const auto& [plain, sign] : signs) text.replace(plain, sign);
    return text;
}

std::string translatedPattern(const std::string& pattern) {
    const QString here = QCoreApplication::translate("drillwave::Message", pattern.c_str());
    // what is in a table of the core too, as the name of a parameter
    return withSigns(here == fromView(pattern) ? coreText(pattern) : here).toStdString();
}

QString translated(const Message& message) {
    return QString::fromStdString(message.said(translatedPattern));
}

QStringList translatedEach(const std::vector<Message>& sentences) {
    QStringList all;
    for (const Message& sentence : sentences) all << translated(sentence);
    return all;
}

QString translatedAll(const std::vector<Message>& sentences) {
    return translatedEach(sentences).join(QLatin1Char(' '));
}

QString translated(const ScenarioError& error) {
    QStringList lines;
    for (const Message& line : error.messages()) lines << translated(line);
    return lines.join(QLatin1Char('\n'));
}

QString shownSymbol(std::string_view symbol) {
    return fromView(symbol).replace(u'0', QStringLiteral("₀"));
}

QString coreText(std::string_view text) {
    return text.empty() ? QString() : QCoreApplication::translate("core", std::string(text).c_str());
}

QString coreName(std::string_view name) {
    return coreText(fromView(name).replace(u'_', u' ').toStdString());
}

QString parameterLabel(const Parameter& parameter) {
    return translated(labelMessage(parameter));
}

QString parameterLabel(const Parameter& parameter, const Scenario& scenario) {
    return translated(labelMessage(parameter, scenario));
}

QString parameterTitle(const Parameter& parameter, const Scenario& scenario) {
    return parameter.address ? parameterLabel(parameter, scenario) : parameterTitle(parameter);
}

QString parameterTitle(const Parameter& parameter) {
    return translated(titleOf(parameter));
}

Message withTitles(Message message) {
    if (message.isWords) {
        const KeptParameter parameter = findParameter(message.pattern);
        return parameter ? titleOf(*parameter) : message;
    }
    for (Message& argument : message.arguments) argument = withTitles(std::move(argument));
    return message;
}

}  // namespace drillwave
