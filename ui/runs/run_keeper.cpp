// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_keeper.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "core/archive/kept_runs.h"
#include "core/yaml/scenario_reader.h"
#include "ui/document/table_name.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

std::string nativePath(const QString& path) {
    return QFile::encodeName(path).toStdString();
}

}  // namespace

RunKeeper::RunKeeper(Document& document, Runs& runs, QObject* parent, Write write)
    : QObject(parent), m_document(document), m_runs(runs), m_write(std::move(write)) {
    m_due.setSingleShot(true);
    m_due.setInterval(0);
    connect(&m_due, &QTimer::timeout, this, &RunKeeper::begin);
    connect(&document, &Document::saved, this, &RunKeeper::followSaved);
    connect(&document, &Document::replaced, this, [this] {
        leave();
        read();
    });
    connect(&runs, &Runs::changed, this, &RunKeeper::writeSoon);
    connect(&runs, &Runs::differs, this,
            [this](const QString& sentence) { emit failed(tr("A run has changed."), sentence); });
}

RunKeeper::~RunKeeper() {
    blockSignals(true);
    finish();
}

QString RunKeeper::folder() const {
    return QFile::decodeName(m_folder.path().c_str());
}

void RunKeeper::moveTo(const QString& path) {
    m_path = path;
    m_folder = path.isEmpty() ? RunsFolder() : RunsFolder(runsFolderOf(nativePath(path)));
    m_partial = false;
    m_runs.reserve({});
}

// What is kept goes with its file.
void RunKeeper::leave() {
    finishAndTell();
    const bool wasKept = m_kept;
    setKept(false);
    moveTo(m_document.path());
    if (wasKept) m_runs.clear();
}

void RunKeeper::read() {
    if (m_path.isEmpty()) return;
    const KeptRuns found = readRuns(m_folder.path(), nativePath(m_path));
    m_runs.reserve(found.foreign);
    m_folder.adopt(runFiles(found.runs));
    if (!m_folder.hasFiles() && found.problems.empty()) return;  // an index without runs is one all the same
    QStringList problems;
    for (const std::string& problem : found.problems) problems << QString::fromStdString(problem);
    for (const QString& title : m_runs.add(found.runs))
        problems << tr("%1: too many runs are shown already; remove some and open the file again").arg(title);
    for (const int number : found.foreign)
        if (const Run* run = m_runs.find(number))
            problems
                << tr("%1: its file would replace another one in %2; remove the run and open the file again")
                       .arg(run->title(), QDir::toNativeSeparators(folder()));
    // Written without them, the index would lose those that are not on show.
    m_partial = !problems.isEmpty();
    setKept(!m_partial);
    if (!problems.isEmpty())
        emit failed(tr("Not all runs that are kept with this file can be shown."),
                    problems.join(QLatin1Char('\n')));
}

void RunKeeper::followSaved() {
    if (m_document.path() == m_path) return;
    finishAndTell();
    moveTo(m_document.path());
    if (!m_kept) return read();
    if (holdsOthers()) {
        setKept(false);
        emit othersFound(folder());
    } else {
        order({Order::Reason::wish, ExistingFiles::kept, tr("The runs are not kept beside the new file.")});
        begin();
    }
}

bool RunKeeper::holdsOthers() {
    finishAndTell();
    if (folder().isEmpty()) return false;
    return m_partial || (!m_folder.hasFiles() && QFileInfo::exists(folder())) ||
           !m_folder.foreignFile(runFiles(m_runs.toKeep())).empty();
}

QString RunKeeper::keep(ExistingFiles existing) {
    if (folder().isEmpty())
        return tr("The scenario has no file yet: save it first, the runs are kept beside it.");
    order({Order::Reason::wish, existing, tr("The runs are not kept.")});
    setKept(true);
    begin();
    return {};
}

void RunKeeper::giveUp() {
    m_order.reset();
    finishAndTell();
    setKept(false);
    m_folder.remove();
}

void RunKeeper::setKept(bool kept) {
    if (kept == m_kept) return;
    m_kept = kept;
    emit keptChanged(kept);
}

// Tables that are named relative to another folder are named relative to the scenario's.
std::vector<NamedFile> RunKeeper::files() const {
    std::vector<KeptRun> runs = m_runs.toKeep();
    for (KeptRun& run : runs) {
        std::string& table = run.contents.scenario.pulse.tableFile;
        const std::string seen = tableSeenFrom(m_path, QFile::decodeName(run.contents.source.c_str()), table);
        if (seen == table) continue;
        table = seen;
        run.contents.text = writeScenario(run.contents);
    }
    return runFiles(runs);
}

void RunKeeper::writeSoon() {
    if (!m_kept) return;
    // A wish that waits writes the change too.
    if (!m_order) order({Order::Reason::change, ExistingFiles::kept, tr("The runs are no longer kept.")});
    m_due.start();
}

void RunKeeper::order(Order order) {
    m_order = std::move(order);
}

// The worker does one after another: the end of what it writes begins what has come meanwhile.
void RunKeeper::begin() {
    m_due.stop();
    if (m_job) return;
    if (const QString problem = prepare(); !problem.isEmpty()) return emit failed(m_failure, fail(problem));
    if (!m_job) return;
    m_worker.submit([this, job = m_job](const std::stop_token& /*stop*/) -> Worker::Delivery {
        job->run();
        return [this, job] {
            if (job != m_job) return;
            if (const QString problem = take(); !problem.isEmpty()) emit failed(m_failure, problem);
            begin();
        };
    });
}

// Makes a job of what is ordered and differs from what is there. Returns why that cannot be written.
QString RunKeeper::prepare() {
    const std::optional<Order> order = std::exchange(m_order, std::nullopt);
    if (!order) return {};
    m_failure = order->failure;
    try {
        std::vector<NamedFile> wanted = files();
        if (order->reason == Order::Reason::change && m_folder.holds(wanted)) return {};
        m_job = std::make_shared<Job>(Job{m_write, m_folder, std::move(wanted), order->existing, {}, {}});
        return {};
    } catch (const ScenarioError& error) {
        return translated(error);
    }
}

void RunKeeper::Job::run() {
    problem = write(folder, files, existing);
    foreignNumbers = folder.foreignNumbers();
}

// What has come of a job that is done.
QString RunKeeper::take() {
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    if (!job->problem->isEmpty()) return fail(translated(*job->problem));
    m_folder = std::move(job->folder);
    m_partial = false;
    m_runs.reserve(std::move(job->foreignNumbers));
    return {};
}

QString RunKeeper::fail(const QString& problem) {
    m_order.reset();
    m_due.stop();
    setKept(false);
    return problem;
}

QString RunKeeper::finish() {
    m_due.stop();
    while (m_job || m_order) {
        if (!m_job) {
            if (const QString problem = prepare(); !problem.isEmpty()) return fail(problem);
            if (!m_job) break;
        }
        // Whether the worker had begun with it or not.
        m_worker.cancel();
        m_worker.waitForThread();
        if (!m_job->problem) m_job->run();
        if (const QString problem = take(); !problem.isEmpty()) return problem;
    }
    return {};
}

void RunKeeper::finishAndTell() {
    if (const QString problem = finish(); !problem.isEmpty()) emit failed(m_failure, problem);
}

}  // namespace drillwave
