// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/record_question.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <fstream>
#include <stdexcept>

#include "core/model/blow_traits.h"
#include "core/signal/signal_option.h"
#include "core/text/decimal_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

[[noreturn]] void refuseRecord(const Message& reason) {
    throw std::runtime_error(translated(reason).toStdString());
}

std::vector<GaugePlace> placesOfGauges(const RecordQuestion& question) {
    std::vector<GaugePlace> places;
    for (const GaugeChoice& gauge : question.gauges)
        if (std::optional<GaugePlace> place = gaugePlace(question.scenario, gauge.distance))
            places.push_back(std::move(*place));
    return places;
}

const char* lawWord(LawChoice law) {
    switch (law) {
        case LawChoice::automatic:
            return "auto";
        case LawChoice::bilinear:
            return "bilinear";
        case LawChoice::corner:
            return "corner";
        case LawChoice::file:
            break;
    }
    return "file";
}

QString toleranceWord(const KnownTolerance& known) {
    const std::string_view key = known.key;
    if (key == "gain" || key == "zero") return fromView(formatNumber(100 * known.tolerance)) + u'%';
    const bool isArea = key.ends_with(".area");
    const Quantity quantity = isArea ? Quantity::area : Quantity::length;
    QString word =
        fromView(formatQuantity(known.tolerance, quantity, *findUnit(quantity, isArea ? "mm^2" : "mm")));
    return word.remove(u' ');
}

}  // namespace

Scenario scenarioForRecord(Scenario scenario, LawChoice law) {
    if (law != LawChoice::file) scenario.bitRock = {};
    scenario.drill = {};
    return scenario;
}

QString missingIn(const RecordQuestion& question) {
    if (!hasUnits(question.scenario))
        return tr(
            "Identify needs a scenario with physical units: a record of a gauge is in seconds and "
            "newtons. Edit ▸ Make a rig of these groups makes one.");
    if (question.path.isEmpty())
        return tr(
            "Identify reads stiffness, elasticity and gap of the rock from strain gauges on the rod. Open a "
            "record of one blow.");
    if (question.gauges.empty()) return tr("Choose the column of the gauge.");
    for (const GaugeChoice& gauge : question.gauges) {
        if (!(gauge.distance > 0))
            return tr("Type the distance of gauge %1 from the bit face.").arg(fromView(gauge.name()));
        if (!gaugePlace(question.scenario, gauge.distance))
            return tr("Gauge %1 is not on a uniform section of the rod or string: correct its distance "
                      "from the bit face.")
                .arg(fromView(gauge.name()));
    }
    return translated(gaugePairProblem(question.gauges, placesOfGauges(question)));
}

IdentifiedRecordPtr identifiedRecord(const RecordQuestion& question,
                                     const StudyFeed<IdentifiedRecordPtr>& feed) {
    auto answer = std::make_shared<IdentifiedRecord>();
    answer->question = question;
    IdentifyQuestion& asked = answer->report.question;
    asked.scenario = question.scenario;
    asked.law = question.law;
    asked.dispersion = question.dispersion;
    asked.barBehind = question.barBehind;
    asked.known = question.known;
    const std::string file = QFileInfo(question.path).fileName().toStdString();
    std::ifstream in(QFile::encodeName(question.path).toStdString(), std::ios::binary);
    if (!in) refuseRecord(about(file, translatable("cannot be read")));
    GaugeReading reading =
        readGauges(in, question.settings, question.gauges, placesOfGauges(question), feed.stop);
    if (feed.stop.stop_requested()) return answer;
    if (!reading.problem.isEmpty()) refuseRecord(about(file, reading.problem));
    if (!reading.questions.empty())
        refuseRecord(
            {translatable("%1: the table does not state this: %2. Open the record again and choose it."),
             {file, reading.questions.front()}});
    reading.record.file = file;
    asked.records.push_back(std::move(reading.record));
    if (const std::vector<Message> problems = identifyProblems(asked); !problems.empty())
        refuseRecord(inOneLine(problems));
    answer->report.findings = runIdentify(asked, 1, feed.stop, {}, [&](RecordAnswer first) {
        auto shown = std::make_shared<IdentifiedRecord>(*answer);
        shown->report.findings.records.push_back(std::move(first));
        feed.show(shown);
    });
    return answer;
}

QStringList identifyWords(const RecordQuestion& question) {
    QStringList words{QStringLiteral("identify"), QStringLiteral("--signals"),
                      QDir::toNativeSeparators(question.path)};
    for (const GaugeChoice& gauge : question.gauges)
        words << QStringLiteral("--gauge")
              << QStringLiteral("%1@%2").arg(fromView(gauge.name()),
                                             fromView(formatQuantity(gauge.distance, Quantity::length,
                                                                     *findUnit(Quantity::length, "m")))
                                                 .remove(u' '));
    if (question.law != LawChoice::automatic)
        words << QStringLiteral("--law") << QLatin1String(lawWord(question.law));
    if (question.barBehind) words << QStringLiteral("--backing") << QStringLiteral("bar");
    if (question.dispersion != DispersionChoice::fit)
        words << QStringLiteral("--dispersion")
              << (question.dispersion == DispersionChoice::bar ? QStringLiteral("bar")
                                                               : QStringLiteral("none"));
    for (const KnownTolerance& known : question.known)
        words << QStringLiteral("--known")
              << QStringLiteral("%1=+-%2").arg(fromView(known.key), toleranceWord(known));
    for (const auto& [name, value] : recorderSettings(question.settings)) {
        words << QStringLiteral("--") + fromView(name);
        if (!value.empty()) words << fromView(value);
    }
    return words;
}

}  // namespace drillwave
