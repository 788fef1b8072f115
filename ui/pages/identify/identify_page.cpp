// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/identify_page.h"

#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <chrono>
#include <cmath>
#include <sstream>

#include "core/archive/identified_document.h"
#include "core/disk/file_bytes.h"
#include "core/signal/detected_table.h"
#include "core/signal/text_lines.h"
#include "core/text/enum_names.h"
#include "ui/form/choice_box.h"
#include "ui/form/section_box.h"
#include "ui/pages/identify/gauge_fields.h"
#include "ui/pages/identify/identify_panel.h"
#include "ui/pages/identify/known_fields.h"
#include "ui/pages/identify/record_list.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/labelled_control.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::size_t headBytes = std::size_t{1} << 18;  // of a table, in which its columns are found
constexpr std::size_t headLines = 2000;
constexpr int narrowPage = 800;     // [px], where the answer stands below the plots
constexpr int rowsOfPlots = 46;     // of text
constexpr double placeStep = 1e-4;  // to which a dragged gauge is placed [m]

/// The value chosen in a box whose entries are in the order of the enumeration.
template <class Choice>
Choice chosen(const ChoiceBox& box) {
    return allValues<Choice>[static_cast<std::size_t>(box.currentIndex())];
}

}  // namespace

IdentifyPage::IdentifyPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_gauges(new GaugeFields(this)),
      m_law(makeChoice("law", tr("force–penetration"), tr("The loading curve that is fitted"),
                       {tr("automatic"), tr("one line"), tr("yields once"), tr("that of the scenario")})),
      m_side(new QWidget(this)),
      m_records(new RecordList(m_side)),
      m_panel(new IdentifyPanel(m_side)) {
    setObjectName(QStringLiteral("identify"));
    auto* side = new QVBoxLayout(m_side);
    side->setContentsMargins(0, 0, 0, 0);
    side->setSpacing(2);
    side->addWidget(m_records);
    side->addWidget(m_panel, 1);
    m_records->hide();
    showSide(false);
    PlotWidget* plot = arrange(
        {makeRecordBox(), m_gauges, labelled(tr("force–penetration"), m_law, this), makeKnownBox()}, m_side);
    stackBelow(narrowPage);
    setLeastLines(rowsOfPlots);
    m_frame = new FigureFrame(plot);
    useFrame(*m_frame, tr("Record with the model, what the model leaves over, and force over penetration"));
    watch(m_asked.job());
    m_asked.job().setTimeLimit(std::chrono::milliseconds(0));  // the user has asked for it
    connect(m_gauges, &GaugeFields::changed, this, &IdentifyPage::requestUpdate);
    connect(m_known, &KnownFields::changed, this, &IdentifyPage::requestUpdate);
    connect(m_records, &RecordList::removeWanted, this, &IdentifyPage::removeRecord);
    connect(m_records, &RecordList::chosen, this, [this](int row) {
        m_chosen = m_records->item(row, 0)->text();
        if (m_shown) draw();
    });
    connect(m_panel, &IdentifyPanel::useWanted, this, &IdentifyPage::useRock);
    connect(m_panel, &IdentifyPanel::pinWanted, this, &IdentifyPage::pinRock);
    connect(m_panel, &IdentifyPanel::designWanted, this, &IdentifyPage::designDraws);
    connect(m_panel, &IdentifyPanel::toleranceWanted, this, &IdentifyPage::goToTolerance);
    connect(m_frame, &FigureFrame::handleMoved, this, &IdentifyPage::moveArrival);
    connect(m_frame, &FigureFrame::handleReleased, this, [this](double time) {
        moveArrival(time);
        requestUpdate();
    });
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        if (isVisible()) present();
    });
}

QWidget* IdentifyPage::makeRecordBox() {
    auto* box = new QWidget(this);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* open = new QPushButton(tr("Open record…"), box);
    open->setObjectName(QStringLiteral("openRecord"));
    open->setToolTip(tr(
        "Tables of samples, one or several along a hole: time and strain, force or the output of a bridge"));
    connect(open, &QPushButton::clicked, this, &IdentifyPage::recordWanted);
    m_more = new QPushButton(tr("Add…"), box);
    m_more->setObjectName(QStringLiteral("addRecords"));
    m_more->setToolTip(tr("Adds records of further blows, whose tables are read like the first"));
    m_more->hide();
    connect(m_more, &QPushButton::clicked, this, &IdentifyPage::moreRecordsWanted);
    m_name = new QLabel(box);
    m_name->setObjectName(QStringLiteral("recordName"));
    m_name->setTextFormat(Qt::PlainText);
    layout->addWidget(open);
    layout->addWidget(m_more);
    layout->addWidget(m_name);
    return box;
}

ChoiceBox* IdentifyPage::makeChoice(const char* name, const QString& title, const QString& tip,
                                    const QStringList& entries) {
    auto* box = new ChoiceBox(this);
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(title);
    box->setToolTip(tip);
    box->addItems(entries);
    connect(box, &QComboBox::currentIndexChanged, this, &IdentifyPage::requestUpdate);
    return box;
}

QWidget* IdentifyPage::makeKnownBox() {
    m_knownBox = new SectionBox(tr("Known tolerances"), this);
    m_known = new KnownFields(m_knownBox->content());
    m_backing = makeChoice("backing", tr("behind the rock"), tr("Support of the specimen"),
                           {tr("rigid"), tr("a bar like that of the gauge")});
    m_dispersion = makeChoice("dispersion", tr("dispersion"),
                              tr("How much of the dispersion of a round bar is taken into account"),
                              {tr("automatic"), tr("round bar"), tr("none")});
    m_blows = makeChoice("blows", tr("blows of a record"), tr("Blows of a record that are identified"),
                         {tr("the first"), tr("all of them")});
    auto* more = new QHBoxLayout;
    more->addWidget(labelled(tr("behind the rock"), m_backing, this));
    more->addWidget(labelled(tr("dispersion"), m_dispersion, this));
    more->addWidget(labelled(tr("blows of a record"), m_blows, this));
    more->addStretch();
    auto* layout = new QVBoxLayout(m_knownBox->content());
    layout->setContentsMargins(8, 0, 0, 0);
    layout->addWidget(m_known);
    layout->addLayout(more);
    m_knownBox->rememberAs(QStringLiteral("identify/known"), SectionBox::Begin::folded);
    m_knownBox->hide();
    return m_knownBox;
}

void IdentifyPage::openRecords(const QStringList& paths, const SignalOptions& settings) {
    m_paths.clear();
    m_settings = settings;
    m_chosen.clear();
    takeFiles(paths);
    const FileBytes start = readStart(QFile::encodeName(m_paths.first()).toStdString(), headBytes);
    std::istringstream in(start.bytes);
    const std::vector<std::string> lines = firstLines(in, headLines);
    DetectedTable table = detectTable(lines);
    if (settings.separator) table.format.separator = *settings.separator;
    if (settings.decimal) table.format.decimal = *settings.decimal;
    if (settings.separator || settings.decimal) table = detectTable(lines, table.format);
    if (settings.firstLine) table = tableFrom(lines, table.format, *settings.firstLine);
    m_gauges->setColumns(table.columns);  // which asks
}

void IdentifyPage::addRecords(const QStringList& paths) {
    if (paths.isEmpty()) return;
    takeFiles(paths);
    requestUpdate();
}

void IdentifyPage::takeFiles(const QStringList& paths) {
    m_paths += paths;
    m_paths.removeDuplicates();
    ++m_opened;
    showNames();
}

// The settings are of all tables: the list goes on without the first.
void IdentifyPage::removeRecord(const QString& path) {
    m_paths.removeAll(path);
    showNames();
    requestUpdate();
}

void IdentifyPage::showNames() {
    m_more->setVisible(hasRecords());
    m_name->setText(hasRecords() ? sourceWords() : QString());
    m_name->setToolTip(withoutMarkup(m_paths.join(u'\n')));
}

/// Names one record, and counts several.
QString IdentifyPage::sourceWords() const {
    return m_paths.size() == 1 ? QFileInfo(m_paths.first()).fileName() : tr("%1 records").arg(m_paths.size());
}

RecordQuestion IdentifyPage::question() const {
    RecordQuestion question;
    question.law = chosen<LawChoice>(*m_law);
    question.scenario = scenarioForRecord(scenario(), question.law);
    question.paths = m_paths;
    question.opened = m_opened;
    question.settings = m_settings;
    question.gauges = m_gauges->gauges();
    question.dispersion = chosen<DispersionChoice>(*m_dispersion);
    question.barBehind = m_backing->currentIndex() == 1;
    question.allBlows = m_blows->currentIndex() == 1;
    question.known = m_known->known();
    return question;
}

// The fields are those of the section that the gauge is on.
void IdentifyPage::showKnown(const RecordQuestion& question) {
    double nearest = INFINITY;
    for (const GaugeChoice& gauge : question.gauges) nearest = std::min(nearest, gauge.distance);
    const std::optional<GaugePlace> place =
        hasUnits(question.scenario) && std::isfinite(nearest) && nearest > 0
            ? gaugePlace(question.scenario, nearest)
            : std::nullopt;
    m_knownBox->setVisible(place.has_value() && hasRecords());
    if (place) m_known->present(question.scenario, *place);
}

void IdentifyPage::ask() {
    m_gauges->present(scenario());
    showKnown(question());
    RecordQuestion asked = question();
    const QString missing = missingIn(asked);
    if (missing.isEmpty()) {
        m_asked.ask(std::move(asked));
        return showRecords();
    }
    m_asked.job().forget();
    m_shown.reset();
    showRecords();
    showSide(false);
    showNothingAsked(missing);
}

/// Shows the panel or empties it, and leaves no room beside the plots where there is nothing to show.
void IdentifyPage::showSide(bool hasAnswer) {
    if (!hasAnswer) m_panel->clear();
    m_panel->setVisible(hasAnswer);
    m_side->setVisible(hasAnswer || !m_records->isHidden());
}

/// Returns the answer of the row that the user has chosen, else the one that the sentence is about.
const RecordAnswer& IdentifyPage::shownRecord() const {
    const IdentifyFindings& findings = m_shown->report.findings;
    for (const RecordAnswer& record : findings.records)
        if (nameOf(record) == m_chosen) return record;
    return findings.main();
}

QString IdentifyPage::nameOf(const RecordAnswer& record) const {
    return fromView(recordName(record, m_shown->question.allBlows));
}

// Files that have no answer yet have a row, too: an unreadable one can be removed.
void IdentifyPage::showRecords() {
    std::vector<RecordList::Row> rows;
    int shown = -1;
    const QStringList names = recordNames(m_paths);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const std::size_t before = rows.size();
        if (m_shown)
            for (const RecordAnswer& record : m_shown->report.findings.records) {
                if (fromView(record.file) != names[i]) continue;
                if (&record == &shownRecord()) shown = static_cast<int>(rows.size());
                const LocalStyle style = LocalStyle::of(document().units());
                rows.push_back({nameOf(record), m_paths[i], translated(recordVerdict(record)),
                                record.refusal ? QString()
                                               : fromView(style.number(100 * record.match.misfit, 2)) +
                                                     QStringLiteral(" %")});
            }
        if (rows.size() == before) rows.push_back({names[i], m_paths[i], QStringLiteral("…"), {}});
    }
    m_records->setVisible(rows.size() > 1);
    m_records->present(std::move(rows), shown);
    showSide(!m_panel->isHidden());
}

void IdentifyPage::present() {
    const IdentifiedRecordPtr* value = m_asked.value();
    if (!value) return;
    const IdentifyReport& report = (*value)->report;
    if (report.findings.records.empty()) return;  // stopped
    const ShownUnits units = unitsFor((*value)->question.scenario);
    if (m_shown == *value && m_shownUnits == units) return;
    m_shown = *value;
    m_shownUnits = units;
    draw();
}

void IdentifyPage::draw() {
    const IdentifyReport& report = m_shown->report;
    const RecordAnswer& answer = shownRecord();
    const LocalStyle style = LocalStyle::of(document().units());
    const bool hasSeveral = report.findings.records.size() > 1;
    const QString ofRecord = translated(identifySentence(answer));
    QString sentence = hasSeveral ? translated(recordsSentence(report.findings, style)) : ofRecord;
    if (m_shown->isPartial)
        sentence += u' ' + (m_paths.size() > 1
                                ? tr("Further records and laws are being tried; they can change the answer.")
                                : tr("Other laws are being tried; they can widen the intervals."));
    showRecords();
    const QString more = hasSeveral ? QStringLiteral("%1: %2").arg(nameOf(answer), ofRecord) : QString();
    if (answer.refusal) {
        showSide(false);
        showNothing(ofRecord);
        return say(sentence, more);
    }
    m_frame->present(
        {identifyFigure(report.findings, answer),
         {m_shownUnits, [&choice = document().units()](const Parameter& parameter) -> const Unit& {
              return choice.fieldUnit(parameter);
          }}});
    plot()->keyPoint().offer(m_frame->keyPlaces());
    m_frame->giveMeanings(*plot());
    m_panel->present(report, answer, style);
    m_panel->setEnabled(!m_shown->isPartial);
    showSide(true);
    say(sentence, more);
    redraw();
}

// The gauge is where a wave needs that time to the rock and back.
void IdentifyPage::moveArrival(double time) {
    if (!m_shown || shownRecord().refusal) return;
    const RecordQuestion& asked = m_shown->question;
    const RecordAnswer& answer = shownRecord();
    const std::optional<GaugePlace> place = gaugePlace(asked.scenario, asked.gauges.front().distance);
    if (!place) return;
    const double late = time - answer.curves.front - answer.match.roundTripOfFile;
    std::vector<double> distances;
    for (const GaugeChoice& gauge : asked.gauges)
        distances.push_back(std::round((gauge.distance + late * place->waveSpeed / 2) / placeStep) *
                            placeStep);
    m_gauges->setDistances(distances);
}

void IdentifyPage::useRock() {
    if (!m_shown) return;
    try {
        ScenarioDocument contents = document().contents();
        contents.text = document().text().toStdString();
        load(identifiedDocument(m_shown->report, std::move(contents)),
             tr("use the rock identified from %1").arg(sourceWords()));
    } catch (const ScenarioError& error) {
        say(translated(error));
    }
}

void IdentifyPage::pinRock() {
    if (m_shown) pin(identifiedScenario(scenario(), m_shown->report.findings));
}

// The file of the command is the scenario with this rock.
void IdentifyPage::designDraws() {
    if (!m_shown) return;
    const IdentifiedRecordPtr answer = m_shown;
    const auto isUsed = [&] { return identifiedScenario(scenario(), answer->report.findings) == scenario(); };
    if (!isUsed()) useRock();
    if (isUsed()) emit drawsWanted(sourceWords(), QByteArray::fromStdString(posteriorCsv(answer->report)));
}

void IdentifyPage::goToTolerance(const QString& key) {
    m_knownBox->setOpen(true);
    m_known->goTo(key.toStdString());
}

QList<PageExport> IdentifyPage::exports() const {
    QList<PageExport> all = StudyPage::exports();
    // `why` says why an answer has no such table.
    const auto add = [&](const QString& title, const QString& tip, const char* stem, auto table, auto why) {
        PageExport added = all.first();
        added.title = title;
        added.toolTip = tip;
        added.fileStem = QLatin1String(stem);
        added.csv = [this, table] { return QByteArray::fromStdString(table(m_shown->report)); };
        added.obstacle = [this, why] {
            const QString unfinished = obstacle();
            if (!unfinished.isEmpty()) return unfinished;
            return m_shown ? why(m_shown->report) : tr("There is no answer yet.");
        };
        all.insert(all.size() - 1, added);
    };
    add(tr("D&raws for Design…"), tr("Rows of values that the record allows, for design --draws"),
        "_posterior", posteriorCsv, [](const IdentifyReport& report) {
            return posteriorCsv(report).empty() ? tr("The record does not fix the rock well enough.")
                                                : QString();
        });
    add(tr("&Table of records…"), tr("A row for each record with its values, intervals and verdicts"),
        "_records", recordsCsv, [](const IdentifyReport& report) {
            return report.findings.records.size() > 1 ? QString() : tr("There is only one record.");
        });
    return all;
}

QByteArray IdentifyPage::csv() const {
    return m_shown ? QByteArray::fromStdString(matchCsv(m_shown->report)) : QByteArray();
}

QString IdentifyPage::answerText() const {
    return m_shown ? withSigns(fromView(identifyText(m_shown->report, LocalStyle::of(document().units()))))
                   : StudyPage::answerText();
}

QStringList IdentifyPage::commandWords() const {
    const RecordQuestion asked = question();
    return missingIn(asked).isEmpty() ? identifyWords(asked) : QStringList();
}

QString IdentifyPage::command() const {
    const QStringList words = commandWords();
    return words.isEmpty() ? QString() : commandText(document(), words.first(), words.mid(1));
}

}  // namespace drillwave
