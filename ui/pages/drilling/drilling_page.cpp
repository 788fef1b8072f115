// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/drilling_page.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "core/archive/result_scenario.h"
#include "core/contact/contact_law.h"
#include "core/model/assignments.h"
#include "core/report/alert_words.h"
#include "core/report/drilling_figure.h"
#include "core/report/drilling_report.h"
#include "core/report/drilling_scan_report.h"
#include "core/report/report_studies.h"
#include "core/report/sequence_words.h"
#include "ui/form/rig_dialog.h"
#include "ui/form/section_box.h"
#include "ui/pages/drilling/drilling_table.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/command_text.h"
#include "ui/pages/study/missing_fields.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int plotLinesOfRow = 16;      // one row of axes
constexpr int plotLinesOfDetails = 30;  // two more
constexpr double mostSecondsUnasked = 2;
constexpr int clickedDigits = 3;  // a value that the hand has chosen to a pixel

ShownSequence shownSequence(const DrillingAnswer& answer) {
    return {answer.question.scenario, answer.question.settings, answer.blows(), answer.result.get(),
            answer.corOverGap};
}

}  // namespace

DrillingPage::DrillingPage(Document& document, QWidget* parent)
    : StudyPage(document, parent),
      m_missing(new MissingFields({"drill.blow_frequency", "drill.thrust"}, document.units(), this)),
      m_table(new DrillingTable(this)),
      m_march([student = std::make_shared<DrillingCache>()](const DrillingQuestion& question,
                                                            const StudyFeed<DrillingAnswer>& feed) {
          return student->answer(question, feed);
      }),
      m_scan(answerDrillingScan),
      m_runMeans(runMeans) {
    m_axis = new AxisFields(tr("scan over"), {"drill.thrust"}, document.units(), this, StudyOf::manyBlows);
    QWidget* scanControls = makeScanControls();
    PlotWidget* widget = arrange({m_axis, m_bracket});
    settingsBox().rememberAs(QStringLiteral("drilling/settings"), SectionBox::Begin::folded);
    addAbove(m_missing, PartOf::question);
    addAbove(scanControls, PartOf::question);
    m_details = new SectionBox(tr("Details"), this);
    m_details->setObjectName(QStringLiteral("details"));
    m_exponent = new QLabel(m_details->content());
    m_exponent->setObjectName(QStringLiteral("exponent"));
    m_exponent->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* inside = new QVBoxLayout(m_details->content());
    inside->addWidget(m_exponent);
    inside->addWidget(m_table);
    addBelow(m_details);
    m_frame = new FigureFrame(widget);
    m_details->rememberAs(QStringLiteral("drilling/details"), SectionBox::Begin::folded);
    connect(m_details, &SectionBox::toggled, this, [this] {
        if (isVisible()) present();
    });
    useFrame(*m_frame, tr("Many blows under a feed"));
    watch(m_march.job());
    watchBeside(m_scan.job());
    watchBeside(m_runMeans.activity());
    connect(m_axis, &AxisFields::changed, this, [this] {
        if (isVisible()) present();
    });
    connect(m_missing, &MissingFields::entered, this, [this](const KeptParameter& parameter, double si) {
        load({{parameter, si}});
    });
    connect(widget, &PlotWidget::clicked, this, &DrillingPage::openBlowAt);
    connect(widget, &PlotWidget::placeTaken, this, &DrillingPage::takeScanned);
    connect(&document.units(), &UnitChoice::changed, this, [this] {
        if (isVisible()) present();
    });
}

QWidget* DrillingPage::makeScanControls() {
    auto* controls = new QWidget(this);
    auto* row = new QHBoxLayout(controls);
    row->setContentsMargins(0, 0, 0, 0);
    m_scanButton = new QPushButton(tr("Scan"), controls);
    m_scanButton->setObjectName(QStringLiteral("scan"));
    m_scanButton->setToolTip(
        tr("Simulates the blows at several values of this parameter, each once from rest and once with a "
           "bouncing machine"));
    connect(m_scanButton, &QPushButton::clicked, this,
            [this] { m_scan.job().state() == StudyState::running ? stopScan() : scan(); });
    m_bracket = new QCheckBox(tr("bracket"), this);
    m_bracket->setObjectName(QStringLiteral("bracket"));
    m_bracket->setToolTip(
        tr("Repeats the scan with a constant feed force and, if a machine mass is given, with a dashpot of "
           "half the impedance of the rod. Makers do not publish their dampers: the results show how much "
           "this matters"));
    row->addWidget(m_scanButton);
    row->addStretch();
    return controls;
}

QString DrillingPage::elsewhere() const {
    return tr("Drilling needs a scenario in physical units. This one has dimensionless groups, so it has no "
              "blow frequency and no feed force.") +
           QLatin1Char(' ') + waysToPhysicalUnits();
}

void DrillingPage::ask() {
    m_missing->present(scenario());
    {
        const QSignalBlocker quiet(m_axis);
        m_axis->present(scenario());
    }
    keepBefore();
    m_march.ask(drillingQuestion(scenario()));
}

// The last complete answer stays faintly behind the growing one.
void DrillingPage::keepBefore() {
    if (m_complete && m_complete->question != drillingQuestion(scenario())) m_before = m_complete;
}

DrillingScanQuestion DrillingPage::scanQuestion() const {
    return drillingScanQuestion(scenario(), m_axis->range(), m_bracket->isChecked());
}

void DrillingPage::scan() {
    if (!m_axis->isValid()) return;
    startScan(scanQuestion());
    present();
}

void DrillingPage::stopScan() {
    m_wantsScan = false;
    m_scan.job().cancel();
    present();
}

void DrillingPage::present() {
    showScanState();
    // One that went out of sight goes on; one that the user has stopped does not.
    if (m_wantsScan && m_scan.job().state() == StudyState::stopped) m_scan.ask(*m_scan.question());
    if (m_march.job().state() == StudyState::failed) return refuse({m_march.job().problem().toStdString()});
    const std::shared_ptr<const DrillingAnswer> answer = m_march.job().value();
    if (!answer) return;
    if (!answer->refusals.empty()) return refuse(answer->refusals);
    if (answer->isComplete()) m_complete = answer;
    draw(*answer);
    scanIfQuick(*answer);
}

// Starts the scan of the fields after the march, where it takes little time. One that was stopped stays so.
void DrillingPage::scanIfQuick(const DrillingAnswer& answer) {
    if (!answer.isComplete() || answer.question != drillingQuestion(scenario()) || !m_axis->isValid()) return;
    const DrillingScanQuestion question = scanQuestion();
    if ((m_scan.question() && *m_scan.question() == question) || scanSeconds(question) > mostSecondsUnasked)
        return;
    startScan(question);
}

void DrillingPage::startScan(const DrillingScanQuestion& question) {
    m_wantsScan = true;
    m_scan.ask(question);
    showScanState();
}

// All pages are as tall as the tallest one: details that are out of sight do not count.
void DrillingPage::hideEvent(QHideEvent* event) {
    StudyPage::hideEvent(event);
    if (!event->spontaneous()) setLeastLines(plotLinesOfRow);
}

void DrillingPage::refuse(const std::vector<Message>& problems) {
    m_table->clearNumbers();
    m_exponent->hide();
    QStringList lines;
    for (const Message& problem : problems) lines << translated(problem);
    showNothing(lines.join(QLatin1Char('\n')));
}

void DrillingPage::draw(const DrillingAnswer& answer) {
    ShownSequence sequence = shownSequence(answer);
    std::optional<ShownSequence> before;
    if (!answer.isComplete() && m_before && m_before->question != answer.question)
        sequence.before = &before.emplace(shownSequence(*m_before));
    const std::optional<ShownScan> scan = shownScan();
    const bool isFirst = m_frame->isEmpty();
    setLeastLines(plotLinesOfRow + (m_details->isOpen() ? plotLinesOfDetails : 0));
    const UnitChoice& choice = document().units();
    m_frame->present(
        {drillingFigure(&sequence, scan ? &*scan : nullptr, m_details->isOpen()),
         figureUnits(shownUnits(choice.physicalSystem(), scalesOf(scenario()), choice.chosen()))});
    if (isFirst) {
        KeyPlaces places = m_frame->keyPlaces();
        places.on = KeyPlaces::On::points;  // from value to value of the scan
        plot()->keyPoint().offer(std::move(places));
    }
    m_frame->giveMeanings(*plot());
    m_frame->setHere(placeAlong(scenario()), {});
    showRuns(double(sequence.settings.blows));
    if (answer.result && answer.result->statistics)
        m_table->present(*answer.result, document().units());
    else
        m_table->clearNumbers();
    m_exponent->setText(answer.result ? withSigns(translated(exponentWords(
                                            *answer.result, LocalStyle::of(document().units()))))
                                      : QString());
    m_exponent->setVisible(!m_exponent->text().isEmpty());
    say(answer.result ? wordsOf(answer) : QStringList{tr("Solving the blows one after another …")});
    redraw();
}

std::optional<ShownScan> DrillingPage::shownScan() const {
    const DrillingScanAnswer* scan = m_scan.value();
    if (!scan || !scan->scan || scan->scan->points.empty() || !m_scan.job().isCurrent()) return std::nullopt;
    const DrillingScanQuestion& asked = *m_scan.question();
    return ShownScan{*scan->scan, scan->constantForce.get(), scan->strongDamper.get(),
                     drillingScanQuestion(scenario(), asked.range, asked.hasBracket) != asked};
}

// Returns the place of a scenario along the scan, in units of the axis.
std::optional<double> DrillingPage::placeAlong(const Scenario& of) const {
    const std::optional<double> value =
        shownScan() ? valueIn(of, *m_scan.question()->range.parameter) : std::nullopt;
    return value ? std::optional(*value * m_frame->xUnit().factor) : std::nullopt;
}

QString DrillingPage::scanName() const {
    const KeptParameter along = m_axis->range().parameter;
    return along ? tr("Scan %1").arg(parameterName(*along)) : tr("Scan");
}

void DrillingPage::showScanState() {
    const StudyActivity& job = m_scan.job();
    const StudyProgress progress = job.progress();
    const bool isRunning = job.state() == StudyState::running;
    m_scanButton->setText(isRunning ? tr("Stop %1/%2").arg(progress.done).arg(progress.wanted) : scanName());
    m_scanButton->setHidden(isScanNew());
    const DrillingScanAnswer* answer = m_scan.value();
    QString problem = job.problem();
    if (answer && job.isCurrent() && !answer->refusals.empty())
        problem = translated(answer->refusals.front());
    m_scanButton->setEnabled(m_axis->isValid() || isRunning);
    m_scanButton->setStatusTip(problem);
}

QStringList DrillingPage::wordsOf(const DrillingAnswer& answer) const {
    const DrillingResult& result = *answer.result;
    const LocalStyle style = LocalStyle::of(document().units());
    QStringList sentences = translatedEach(sequenceSentences(result, style));
    QString numbers =
        tr("Feed force / mean force of the blows φ = %1; %2 round trips of a wave between two blows")
            .arg(numberText(result.groups.phi, 4, locale()),
                 numberText(result.groups.roundTrips, 4, locale()));
    if (result.statistics)
        numbers +=
            tr("; \"in contact\" means within %1 of the rock; %2")
                .arg(QString::fromStdString(style.quantity(
                         contactLimit / lawUnitOfPenetration * result.units.length(), Quantity::length, 2)),
                     translated(motionWords(result)));
    sentences << numbers + QLatin1Char('.');
    for (const Alert& alert : result.alerts)
        if (alert.level == AlertLevel::warning || alert.code == AlertCode::noWaveLoss)
            sentences << (alert.level == AlertLevel::warning ? QStringLiteral("⚠ ") : QString()) +
                             translated(alertMessage(alert, style));
    if (const DrillingScanAnswer* scan = m_scan.value(); scan && m_scan.job().isCurrent()) {
        for (const Message& refusal : scan->refusals) sentences << tr("No scan: %1").arg(translated(refusal));
        const std::optional<Sequence> present = sequenceOf(result);
        if (scan->scan && isScanNew()) {
            const QStringList words = translatedEach(scanSentences(*scan->scan, present, style));
            // The answer has all sentences on the scan except the last, on the limits of the model.
            sentences.front() += u' ' + words.mid(0, words.size() - 1).join(u' ');
            sentences << words.mid(words.size() - 1);
        }
    }
    return sentences;
}

// At their mean penetrations, and along the scan at their mean rates.
void DrillingPage::showRuns(double lastBlow) {
    constexpr auto penetration = static_cast<std::size_t>(DrillingPanel::penetration);
    std::vector<DrillingQuestion> questions;
    for (const Run& run : runs())
        if (run.isShown && hasUnits(run.contents.scenario))
            questions.push_back(runQuestion(run.contents.scenario));
    m_runMeans.ask(questions);
    QVector<RunMark> means, along;
    for (const Run& run : runs()) {
        const Scenario& own = run.contents.scenario;
        if (!run.isShown || !hasUnits(own)) continue;
        const RunMeans* found = m_runMeans.find(runQuestion(own));
        if (!found) continue;
        means.append(
            {run.number, run.title(), {lastBlow, found->penetration * m_frame->yUnitOf(penetration).factor}});
        if (const std::optional<double> place = placeAlong(own))
            along.append({run.number, run.title(), {*place, found->rate * m_frame->yUnit().factor}});
    }
    m_frame->setRunsIn(penetration, means);
    m_frame->setRuns(along);
}

// With Shift a single blow at its gap is pinned, which begins at rest.
void DrillingPage::openBlow(long number, Qt::KeyboardModifiers modifiers) {
    const DrillingAnswer& answer = *m_march.value();
    if (answer.question != drillingQuestion(scenario())) return;  // of an earlier scenario
    const DrillingBlow opened = answer.blows()[static_cast<std::size_t>(number) - 1];
    const DrillingUnits units = drillingUnitsOf(answer.question.scenario);
    if (modifiers & Qt::ShiftModifier)
        return take({{findParameter("bit_rock.gap"), opened.gap * units.length()}}, modifiers);
    const LocalStyle style = LocalStyle::of(document().units());
    const auto length = [&](double value) {
        return QString::fromStdString(style.quantity(value * units.length(), Quantity::length, 3));
    };
    emit blowOpened({answer.question.settings, number},
                    tr("Blow %1 of %2 under the feed, with the waves and the motion it started with: gap %3, "
                       "penetration %4. The panel Result shows a single blow from rest.")
                        .arg(number)
                        .arg(answer.question.settings.blows)
                        .arg(length(opened.gap), length(opened.penetration)));
}

// The scenario stays as it is.
void DrillingPage::openBlowAt(QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers) {
    const auto panel = static_cast<DrillingPanel>(m_frame->panelIn(rect).value_or(0));
    const bool isOfBlows = panel == DrillingPanel::gap || panel == DrillingPanel::penetration;
    const long blow = std::lround(at.x());
    if ((modifiers & ~Qt::ShiftModifier) || !isOfBlows || !m_march.value() || blow < 1) return;
    if (static_cast<std::size_t>(blow) <= m_march.value()->blows().size()) openBlow(blow, modifiers);
}

void DrillingPage::takeScanned(QCPAxisRect* rect, QPointF at, Qt::KeyboardModifiers modifiers) {
    const AxisTarget* target = m_frame->targetIn(rect);
    if ((modifiers & ~Qt::ShiftModifier) || !target) return;
    const double shown = QString::number(at.x(), 'g', clickedDigits).toDouble();
    take({{target->parameter, shown / m_frame->xUnit().factor}}, modifiers);
}

QString DrillingPage::obstacle() const {
    if (QString unfinished = StudyPage::obstacle(); !unfinished.isEmpty()) return unfinished;
    const DrillingAnswer* answer = m_march.value();
    if (!answer->refusals.empty()) return translated(answer->refusals.front());
    return answer->isComplete() ? QString() : translatedAll(sequenceSentences(*answer->result));
}

QByteArray DrillingPage::csv() const {
    const DrillingAnswer* answer = m_march.value();
    if (!answer || !answer->result) return {};
    const std::string scenario = scenarioWith(answer->question.settings);
    if (scenario.empty()) return {};
    return QByteArray::fromStdString(drillingCsv({*answer->result, {}, scenario}, OutputUnits::si));
}

// Empty where it is none.
std::string DrillingPage::scenarioWith(const DrillingSettings& settings) const {
    ScenarioDocument contents;
    const QString problem =
        document().contentsWith({{findParameter("drill.blows"), double(settings.blows)},
                                 {findParameter("drill.settle"), double(settings.settle)}},
                                contents);
    return problem.isEmpty() ? completeScenarioText(contents) : std::string();
}

QList<PageExport> DrillingPage::exports() const {
    QList<PageExport> all = StudyPage::exports();
    PageExport scan;
    scan.title = tr("Data of the &scan…");
    scan.toolTip = tr("The statistics at every value of the scan, as CSV");
    scan.fileStem = QStringLiteral("_scan");
    scan.csv = [this] { return scanCsv(); };
    scan.content = PageExport::Content::wholeFile;
    scan.obstacle = [this] { return isScanNew() ? QString() : tr("There is no scan of this scenario yet."); };
    all.insert(1, scan);
    return all;
}

bool DrillingPage::isMarchNew() const {
    const DrillingAnswer* answer = m_march.value();
    return answer && answer->isComplete() && m_march.job().state() == StudyState::finished &&
           answer->question == drillingQuestion(scenario());
}

bool DrillingPage::isScanNew() const {
    const std::optional<ShownScan> shown = shownScan();
    return shown && !shown->isOld && m_scan.job().state() == StudyState::finished;
}

void DrillingPage::addTo(ReportStudies& studies) const {
    if (isMarchNew()) studies.drilling = m_march.value()->result;
    if (isScanNew()) studies.scan = m_scan.value()->scan;
}

QByteArray DrillingPage::scanCsv() const {
    if (!isScanNew()) return {};
    const DrillingScan& scan = *m_scan.value()->scan;
    return QByteArray::fromStdString(drillingScanCsv({scan, scenarioWith(scan.settings)}, OutputUnits::si));
}

QStringList DrillingPage::commandWords() const {
    const DrillingQuestion question = drillingQuestion(scenario());
    if (!drillingRefusals(question.scenario, question.settings).empty()) return {};
    return {QStringLiteral("drill"), QStringLiteral("--blows"), QString::number(question.settings.blows),
            QStringLiteral("--settle"), QString::number(question.settings.settle)};
}

// The march, and below it the scan where there is one.
QString DrillingPage::command() const {
    QString text = StudyPage::command();
    if (text.isEmpty() || !isScanNew()) return text;
    const QStringList words = commandWords();
    const QString axis = QString::fromStdString(scanAxisText(m_scan.question()->range));
    return text + QLatin1Char('\n') +
           commandText(document(), words.first(),
                       words.mid(1) + QStringList{QStringLiteral("--scan"), axis, QStringLiteral("-o"),
                                                  QStringLiteral("-")});
}

}  // namespace drillwave
