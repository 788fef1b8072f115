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
#include "ui/form/choice_box.h"
#include "ui/form/section_box.h"
#include "ui/pages/identify/gauge_fields.h"
#include "ui/pages/identify/identify_panel.h"
#include "ui/pages/identify/known_fields.h"
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

// In the order of the boxes.
constexpr LawChoice lawChoices[] = {LawChoice::automatic, LawChoice::bilinear, LawChoice::corner,
                                    LawChoice::file};
constexpr DispersionChoice dispersionChoices[] = {DispersionChoice::fit, DispersionChoice::bar,
                                                  DispersionChoice::none};

}  // namespace

IdentifyPage::IdentifyPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_gauges(new GaugeFields(this)),
      m_law(makeChoice("law", tr("law of the rock"), tr("The loading curve that is fitted"),
                       {tr("automatic"), tr("one line"), tr("yields once"), tr("that of the scenario")})),
      m_panel(new IdentifyPanel(this)) {
    setObjectName(QStringLiteral("identify"));
    m_panel->hide();
    PlotWidget* plot =
        arrange({makeRecordBox(), m_gauges, labelled(tr("law"), m_law, this), makeKnownBox()}, m_panel);
    stackBelow(narrowPage);
    setLeastLines(rowsOfPlots);
    m_frame = new FigureFrame(plot);
    useFrame(*m_frame, tr("Record with the model, what the model leaves over, and force over penetration"));
    watch(m_asked.job());
    m_asked.job().setTimeLimit(std::chrono::milliseconds(0));  // the user has asked for it
    connect(m_gauges, &GaugeFields::changed, this, &IdentifyPage::askSoon);
    connect(m_known, &KnownFields::changed, this, &IdentifyPage::askSoon);
    connect(m_panel, &IdentifyPanel::useWanted, this, &IdentifyPage::useRock);
    connect(m_panel, &IdentifyPanel::pinWanted, this, &IdentifyPage::pinRock);
    connect(m_panel, &IdentifyPanel::toleranceWanted, this, &IdentifyPage::goToTolerance);
    connect(m_frame, &FigureFrame::handleMoved, this, &IdentifyPage::moveArrival);
    connect(m_frame, &FigureFrame::handleReleased, this, [this](double time) {
        moveArrival(time);
        askSoon();
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
    open->setToolTip(tr("A table of samples of one blow: time and strain, force or the output of a bridge"));
    connect(open, &QPushButton::clicked, this, &IdentifyPage::recordWanted);
    m_name = new QLabel(box);
    m_name->setObjectName(QStringLiteral("recordName"));
    m_name->setTextFormat(Qt::PlainText);
    layout->addWidget(open);
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
    connect(box, &QComboBox::currentIndexChanged, this, &IdentifyPage::askSoon);
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
    auto* more = new QHBoxLayout;
    more->addWidget(labelled(tr("behind the rock"), m_backing, this));
    more->addWidget(labelled(tr("dispersion"), m_dispersion, this));
    more->addStretch();
    auto* layout = new QVBoxLayout(m_knownBox->content());
    layout->setContentsMargins(8, 0, 0, 0);
    layout->addWidget(m_known);
    layout->addLayout(more);
    m_knownBox->rememberAs(QStringLiteral("identify/known"), SectionBox::Begin::folded);
    m_knownBox->hide();
    return m_knownBox;
}

void IdentifyPage::openRecord(const QString& path, const SignalOptions& settings) {
    m_path = path;
    m_settings = settings;
    m_name->setText(QFileInfo(path).fileName());
    m_name->setToolTip(withoutMarkup(path));
    const FileBytes start = readStart(QFile::encodeName(path).toStdString(), headBytes);
    std::istringstream in(start.bytes);
    const std::vector<std::string> lines = firstLines(in, headLines);
    DetectedTable table = detectTable(lines);
    if (settings.separator) table.format.separator = *settings.separator;
    if (settings.decimal) table.format.decimal = *settings.decimal;
    if (settings.separator || settings.decimal) table = detectTable(lines, table.format);
    if (settings.firstLine) table = tableFrom(lines, table.format, *settings.firstLine);
    m_gauges->setColumns(table.columns);
    askSoon();
}

RecordQuestion IdentifyPage::question() const {
    RecordQuestion question;
    question.law = lawChoices[m_law->currentIndex()];
    question.scenario = scenarioForRecord(scenario(), question.law);
    question.path = m_path;
    question.settings = m_settings;
    question.gauges = m_gauges->gauges();
    question.dispersion = dispersionChoices[m_dispersion->currentIndex()];
    question.barBehind = m_backing->currentIndex() == 1;
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
    m_knownBox->setVisible(place.has_value() && !m_path.isEmpty());
    if (place) m_known->present(question.scenario, *place);
}

void IdentifyPage::ask() {
    m_gauges->present(scenario());
    showKnown(question());
    RecordQuestion asked = question();
    const QString missing = missingIn(asked);
    if (missing.isEmpty()) {
        m_asked.ask(std::move(asked));
        return;
    }
    m_asked.job().forget();
    m_shown.reset();
    m_panel->clear();
    m_panel->hide();
    showNothingAsked(missing);
}

void IdentifyPage::present() {
    const IdentifiedRecordPtr* value = m_asked.value();
    if (!value) return;
    const IdentifyReport& report = (*value)->report;
    if (report.findings.records.empty()) return;  // stopped
    const Scenario& scenario = (*value)->question.scenario;
    const ShownUnits units =
        blow() ? shownUnits(blow()->request.units, scalesOf(scenario), blow()->request.chosenUnits)
               : shownUnits(naturalUnits(scenario), scalesOf(scenario));
    if (m_shown == *value && m_shownUnits == units) return;
    m_shown = *value;
    m_shownUnits = units;
    draw();
}

void IdentifyPage::draw() {
    const IdentifyReport& report = m_shown->report;
    const RecordAnswer& answer = report.findings.main();
    QString sentence = translated(identifySentence(answer));
    if (answer.isFirst) sentence += u' ' + tr("Other laws are being tried; they can widen the intervals.");
    if (answer.refusal) {
        m_panel->clear();
        m_panel->hide();
        return showNothing(sentence);
    }
    m_frame->present(
        {identifyFigure(answer),
         {m_shownUnits, [&choice = document().units()](const Parameter& parameter) -> const Unit& {
              return choice.fieldUnit(parameter);
          }}});
    plot()->keyPoint().offer(m_frame->keyPlaces());
    m_frame->giveMeanings(*plot());
    m_panel->present(report, LocalStyle::of(document().units()));
    m_panel->setEnabled(!answer.isFirst);
    m_panel->show();
    say(sentence);
    redraw();
}

// The gauge is where a wave needs that time to the rock and back.
void IdentifyPage::moveArrival(double time) {
    if (!m_shown || m_shown->report.findings.main().refusal) return;
    const RecordQuestion& asked = m_shown->question;
    const RecordAnswer& answer = m_shown->report.findings.main();
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
             tr("use the rock identified from %1").arg(QFileInfo(m_path).fileName()));
    } catch (const ScenarioError& error) {
        say(translated(error));
    }
}

void IdentifyPage::pinRock() {
    if (m_shown) pin(identifiedScenario(scenario(), m_shown->report.findings));
}

void IdentifyPage::goToTolerance(const QString& key) {
    m_knownBox->setOpen(true);
    m_known->goTo(key.toStdString());
}

QList<PageExport> IdentifyPage::exports() const {
    QList<PageExport> all = StudyPage::exports();
    PageExport draws = all.first();
    draws.title = tr("D&raws for Design…");
    draws.toolTip = tr("Rows of values that the record allows, for design --draws");
    draws.fileStem = QStringLiteral("_posterior");
    draws.csv = [this] { return QByteArray::fromStdString(posteriorCsv(m_shown->report)); };
    draws.obstacle = [this] {
        const QString why = obstacle();
        if (!why.isEmpty() || !m_shown) return why.isEmpty() ? tr("There is no answer yet.") : why;
        return posteriorCsv(m_shown->report).empty() ? tr("The record does not fix the rock well enough.")
                                                     : QString();
    };
    all.insert(1, draws);
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
