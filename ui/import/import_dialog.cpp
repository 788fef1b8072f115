// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>
#include <sstream>

#include "core/disk/file_bytes.h"
#include "core/model/form_conversion.h"
#include "core/signal/text_lines.h"
#include "ui/form/pulse_preview.h"
#include "ui/form/section_box.h"
#include "ui/import/import_preview.h"
#include "ui/import/import_rows.h"
#include "ui/import/table_fields.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr std::size_t startBytes = std::size_t{1} << 18;
constexpr std::size_t mostLines = 2000;
constexpr int summaryLines = 4;

SectionBox* section(const QString& title, QWidget* content, QWidget* parent) {
    auto* box = new SectionBox(title, parent);
    auto* layout = new QVBoxLayout(box->content());
    layout->setContentsMargins(4, 0, 0, 0);
    layout->addWidget(content);
    return box;
}

}  // namespace

ImportDialog::ImportDialog(const QString& path, ImportUse use, const Document& document, QWidget* parent)
    : QDialog(parent),
      m_path(path),
      m_document(document),
      m_name(new QLineEdit(QFileInfo(path).completeBaseName(), this)),
      m_table(new TableFields(this)),
      m_signal(new SignalFields(document.units(), this)),
      m_lines(new FileLines(this)),
      m_plot(new PlotWidget(this)),
      m_drawing(new ImportPlot(m_plot, document.units())),
      m_summary(new QLabel(this)),
      m_message(new QLabel(this)) {
    setWindowTitle(tr("Import – %1").arg(QFileInfo(path).fileName()));
    setObjectName(QStringLiteral("import"));
    auto* middle = new QHBoxLayout;
    middle->addWidget(makeChoices());
    middle->addLayout(makePreview(), 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(middle, 1);
    layout->addWidget(makeButtons());
    m_ask.setSingleShot(true);
    connect(&m_ask, &QTimer::timeout, this, &ImportDialog::ask);
    connect(&m_study.job(), &StudyActivity::changed, this, &ImportDialog::showAnswer);
    // As long as the user has not edited them, zero, sign and times follow from what the table now is.
    connect(m_table, &TableFields::changed, this, [this] {
        m_proposal = Proposal::zero;
        requestUpdate();
    });
    connect(m_table, &TableFields::changed, this,
            [this] { m_lines->present(m_table->lines(), m_table->source().firstLine); });
    connect(m_table, &TableFields::valueColumnChanged, this, [this] {
        m_signal->setUnit(m_table->valueUnit(), m_table->valueKind());
        m_proposal = Proposal::zero;
    });
    connect(m_signal, &SignalFields::changed, this, &ImportDialog::requestUpdate);
    connect(m_signal, &SignalFields::timesAroundPeakWanted, this, [this] {
        if (const ImportPreview* preview = m_study.value(); preview && preview->aroundPeak)
            m_signal->setTimes(preview->aroundPeak);
    });
    connect(m_signal, &SignalFields::visibleTimesWanted, this,
            [this] { m_signal->setTimes(m_drawing->visibleTimes()); });
    connect(&document, &Document::scenarioChanged, this, [this] {
        m_signal->setScenario(m_document.scenario());
        if (this->use() == ImportUse::blow) m_ask.start(0);  // e is that of another rod
        showState();
    });
    connect(&document.units(), &UnitChoice::changed, this, &ImportDialog::showAnswer);
    m_signal->setScenario(document.scenario());
    setUse(use);
    resize(1000, 680);
    readStart();
}

// Fields that have the focus hand over their last edit as they go out of sight: while all of this is there.
ImportDialog::~ImportDialog() {
    hide();
}

QWidget* ImportDialog::makeChoices() {
    auto* choices = new QWidget;
    auto* top = new QWidget(choices);
    auto* form = new QFormLayout(top);
    form->setContentsMargins(4, 4, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_use = addChoice(*form, {"use", tr("import as"), tr("Use of the signal in the program")},
                      {{tr("hammer blow"), static_cast<int>(ImportUse::blow)},
                       {tr("measured N in a section"), static_cast<int>(ImportUse::normalForce)},
                       {tr("measured force on the rock"), static_cast<int>(ImportUse::impactForce)},
                       {tr("record to read the rock from"), static_cast<int>(ImportUse::rockRecord)}});
    m_name->setObjectName(QStringLiteral("name"));
    m_name->setAccessibleName(tr("name"));
    m_name->setToolTip(tr("Name of the measured curve in the list"));
    m_name->setMaxLength(60);
    form->addRow(tr("name"), m_name);
    connect(m_use, &QComboBox::currentIndexChanged, this, [this] { setUse(use()); });
    addRecorders(*form);

    auto* layout = new QVBoxLayout(choices);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->addWidget(top);
    layout->addWidget(section(tr("Table"), m_table, choices));
    layout->addWidget(section(tr("Signal"), m_signal, choices));
    layout->addStretch();
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(choices);
    area->setMinimumWidth(choices->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    area->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    return area;
}

void ImportDialog::addRecorders(QFormLayout& form) {
    auto* row = new QWidget(form.parentWidget());
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_recorder = new QComboBox(row);
    m_recorder->setObjectName(QStringLiteral("recorder"));
    m_recorder->setAccessibleName(tr("recorder"));
    m_recorder->setToolTip(
        tr("Saved settings: columns, units, gauge and amplifier. Select one, or type a name and keep the "
           "present settings."));
    m_recorder->setEditable(true);
    m_recorder->setInsertPolicy(QComboBox::NoInsert);
    m_recorder->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_recorder->lineEdit()->setMaxLength(60);
    m_recorder->lineEdit()->setAccessibleName(m_recorder->accessibleName());
    m_recorder->lineEdit()->setPlaceholderText(tr("none"));
    m_keep = new QPushButton(tr("Keep"), row);
    m_keep->setObjectName(QStringLiteral("keepRecorder"));
    m_keep->setToolTip(tr("Keeps the present settings under this name, for the next record"));
    m_keep->setAutoDefault(false);
    m_keep->setEnabled(false);
    layout->addWidget(m_recorder, 1);
    layout->addWidget(m_keep);
    form.addRow(tr("recorder"), row);
    connect(m_recorder, &QComboBox::activated, this,
            [this](int index) { useRecorder(m_recorders[static_cast<std::size_t>(index)]); });
    connect(m_recorder, &QComboBox::editTextChanged, this,
            [this] { m_keep->setEnabled(!recorder().isEmpty()); });
    connect(m_keep, &QPushButton::clicked, this, &ImportDialog::keepWanted);
}

void ImportDialog::offer(std::vector<Recorder> recorders, Recorder last) {
    m_recorders = std::move(recorders);
    const QSignalBlocker quiet(m_recorder);
    const QString typed = m_recorder->currentText();
    m_recorder->clear();
    for (const Recorder& each : m_recorders) m_recorder->addItem(QString::fromStdString(each.name));
    if (!last.settings.empty()) {
        m_recorder->addItem(tr("as in the last import"));
        m_recorders.push_back(std::move(last));
    }
    m_recorder->setCurrentIndex(-1);
    m_recorder->setEditText(typed);
    m_keep->setEnabled(!recorder().isEmpty());
}

void ImportDialog::useRecorder(const Recorder& recorder) {
    SignalOptions settings;
    if (const Message problem = applyRecorder(recorder, settings); !problem.isEmpty())
        return refuse(translated(problem));
    m_table->use(settings);
    m_signal->use(settings);
}

SignalOptions ImportDialog::settings() const {
    SignalOptions settings;
    m_table->addTo(settings);
    m_signal->addTo(settings);
    return settings;
}

QString ImportDialog::recorder() const {
    return m_recorder->currentText().trimmed();
}

QVBoxLayout* ImportDialog::makePreview() {
    m_plot->setAccessibleName(tr("The record and the part that is used"));
    m_summary->setObjectName(QStringLiteral("summary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_summary->setMinimumHeight(summaryLines * m_summary->fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout;
    layout->addWidget(m_lines);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_summary);
    return layout;
}

QWidget* ImportDialog::makeButtons() {
    m_message->setObjectName(QStringLiteral("message"));
    m_message->setWordWrap(true);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel | QDialogButtonBox::Help, this);
    buttons->button(QDialogButtonBox::Help)->setShortcut(Qt::Key_F1);
    m_take = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    m_take->setObjectName(QStringLiteral("take"));
    m_take->setDefault(true);
    connect(m_take, &QPushButton::clicked, this, [this] {
        if (result()) emit wanted();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::helpRequested, this, &ImportDialog::helpRequested);
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_message, 1);
    layout->addWidget(buttons);
    return row;
}

void ImportDialog::readStart() {
    const FileBytes start = drillwave::readStart(QFile::encodeName(m_path).toStdString(), startBytes);
    m_unreadable = translated(start.problem);
    std::istringstream in(start.bytes);
    m_table->setLines(firstLines(in, mostLines));
}

ImportUse ImportDialog::use() const {
    return static_cast<ImportUse>(chosenValue(*m_use));
}

void ImportDialog::setUse(ImportUse use) {
    choose(*m_use, static_cast<int>(use));
    m_name->setEnabled(use != ImportUse::blow);
    m_proposal = Proposal::zero;
    m_signal->setUse(use);
}

void ImportDialog::requestUpdate() {
    m_refusal.clear();
    m_ask.start(0);
    showState();
}

void ImportDialog::ask() {
    ImportQuestion question{m_path, m_table->source(), m_signal->recipe()};
    if (use() == ImportUse::blow) {
        question.scenario =
            withForce(m_document.scenario());  // a blow takes the place of a hammer of sections
        question.isThinned = m_signal->leavesPoints();
    }
    if (obstacle().isEmpty()) m_study.ask(question);
    showState();
}

// Why there is nothing to be computed.
QString ImportDialog::obstacle() const {
    if (!m_unreadable.isEmpty())
        return QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(m_path), m_unreadable);
    const QString problem = m_table->problem();
    return problem.isEmpty() ? m_signal->problem() : problem;
}

void ImportDialog::showAnswer() {
    const ImportPreview* preview = m_study.value();
    if (m_study.job().isCurrent() && preview) {
        if (preview->problem.isEmpty()) {
            const double shift = preview->signal.start;
            m_drawing->present(*preview, use() == ImportUse::blow ? shift : 0,
                               use() == ImportUse::normalForce ? tr("N, tension +") : tr("F, compression +"));
        } else {
            m_drawing->showNothing(tr("Nothing to show: %1").arg(preview->problem));
            m_plot->replot(QCustomPlot::rpQueuedReplot);
        }
        if (m_study.job().state() == StudyState::finished) proposeFrom(*preview);
        if (preview->estimatedRate) m_table->proposeRate(*preview->estimatedRate);
    }
    showState();
}

// A record of a gauge has its zero line, and of its waves the first is the blow.
void ImportDialog::proposeFrom(const ImportPreview& preview) {
    if (m_proposal == Proposal::none || !preview.problem.isEmpty() || m_ask.isActive()) return;
    if (m_proposal == Proposal::zero) {
        m_proposal = Proposal::signAndTimes;
        const SignalRecipe before = m_signal->recipe();
        m_signal->proposeZero(preview.time);
        if (m_signal->recipe() != before) return;  // sign and peak are those over the zero line
    }
    m_proposal = Proposal::none;
    m_signal->proposeSign(preview.signOfPeak);
    const bool isGauge = m_signal->recipe().zeroLine == ZeroLine::ofFirstSamples;
    const bool isRecord = isGauge || preview.hasBothSigns;  // and no blow that was computed
    m_signal->proposeTimes(use() == ImportUse::blow && isRecord ? preview.aroundPeak : std::nullopt);
}

bool ImportDialog::isBusy() const {
    return m_ask.isActive() || m_study.job().state() == StudyState::running;
}

const ShapedSignal* ImportDialog::result() const {
    const ImportPreview* preview = m_study.value();
    const bool answers = !isBusy() && m_study.job().state() == StudyState::finished &&
                         m_study.job().isCurrent() && obstacle().isEmpty();
    if (!answers || !preview->problem.isEmpty() || !preview->signal.problem.empty()) return nullptr;
    return &preview->signal;
}

MeasuredSignal ImportDialog::measured() const {
    MeasuredSignal signal;
    const ShapedSignal* shaped = result();
    if (!shaped) return signal;
    const QString name = m_name->text().trimmed();
    signal.name = (name.isEmpty() ? QFileInfo(m_path).completeBaseName() : name).toStdString();
    signal.quantity =
        use() == ImportUse::normalForce ? MeasuredQuantity::normalForce : MeasuredQuantity::impactForce;
    signal.place = use() == ImportUse::normalForce ? m_signal->place() : 0;
    signal.points = shaped->points;
    signal.deviation = shaped->deviation;
    return signal;
}

void ImportDialog::refuse(const QString& reason) {
    m_refusal = reason;
    showState();
}

void ImportDialog::showState() {
    const ImportPreview* preview = m_study.value();
    const bool answered = !isBusy() && preview && m_study.job().isCurrent();
    QString message = obstacle();
    if (message.isEmpty() && isBusy()) {
        const StudyProgress progress = m_study.job().progress();
        message = progress.wanted == 0 ? tr("reading …")
                                       : tr("reading … %1 %").arg(100 * progress.done / progress.wanted);
    }
    if (message.isEmpty()) message = m_study.job().problem();
    if (message.isEmpty() && answered)
        message =
            preview->problem.isEmpty() ? QString::fromStdString(preview->signal.problem) : preview->problem;
    if (message.isEmpty()) message = m_refusal;
    m_message->setText(message);
    const bool known = result() != nullptr;
    QString summary = known ? importSummary(*preview, m_document.units()) : QString();
    if (known && use() == ImportUse::blow && !hasUnits(m_document.scenario()))
        summary += QLatin1Char(' ') + tr("Only the shape is taken: this scenario has no physical units.");
    if (known && use() == ImportUse::blow && !isForced(m_document.scenario()))
        summary += QLatin1Char(' ') + tr("The blow replaces the hammer; Undo brings it back.");
    m_summary->setText(summary);
    m_take->setEnabled(known);
}

}  // namespace drillwave
