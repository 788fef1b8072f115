#include "app/output_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <cstdio>

#include "app/command_error.h"

namespace drillwave {

namespace {

bool isStandardOutput(const std::string& path) {
    return path == "-";
}

QString nameOf(const std::string& path) {
    return QFile::decodeName(QByteArray::fromStdString(path));
}

/// Something like /dev/null or a pipe, which cannot be replaced by a file.
bool isDevice(const QFileInfo& info) {
    return info.exists() && !info.isFile() && !info.isDir();
}

}  // namespace

void checkOverwrite(const std::string& path, Overwrite overwrite) {
    const QFileInfo info(nameOf(path));
    if (isStandardOutput(path) || isDevice(info)) return;
    if (info.isDir())
        throw CommandError(ExitCode::unwritableOutput, path + ": is a folder; give the name of a file");
    // A dangling link exists too, as something that would be written through.
    if ((info.exists() || info.isSymLink()) && overwrite == Overwrite::refused)
        throw CommandError(ExitCode::unwritableOutput,
                           path + ": exists already; use --force to overwrite it or choose another name");
}

void makeFolder(const std::string& path) {
    if (!QDir().mkpath(nameOf(path)))
        throw CommandError(ExitCode::unwritableOutput,
                           path + ": the folder cannot be made; choose another one with -o");
}

OutputFile::OutputFile(const std::string& path, Overwrite overwrite) : m_path(path) {
    checkOverwrite(path, overwrite);
    const QString name = nameOf(path);
    bool open = false;
    if (isStandardOutput(path)) {
        auto file = std::make_unique<QFile>();
        open = file->open(stdout, QIODevice::WriteOnly | QIODevice::Unbuffered);
        m_file = std::move(file);
    } else if (isDevice(QFileInfo(name))) {
        m_file = std::make_unique<QFile>(name);
        open = m_file->open(QIODevice::WriteOnly);
    } else {
        m_file = std::make_unique<QSaveFile>(name);
        open = m_file->open(QIODevice::WriteOnly);
    }
    if (!open) fail();
}

void OutputFile::write(std::string_view text) {
    const auto size = static_cast<qint64>(text.size());
    if (m_file->write(text.data(), size) != size) fail();
}

void OutputFile::flush() {
    if (!m_file->flush()) fail();
}

void OutputFile::commit() {
    // QSaveFile's commit() alone misses that the last bytes found no room, and puts a short file in place.
    flush();
    auto* saved = qobject_cast<QSaveFile*>(m_file.get());
    if (saved && !saved->commit()) fail();
}

void OutputFile::fail() const {
    const std::string name = isStandardOutput(m_path) ? "standard output" : m_path;
    throw CommandError(ExitCode::unwritableOutput,
                       name + ": cannot be written: " + m_file->errorString().toStdString() +
                           "; free some space or choose another place with -o");
}

void writeFile(const std::string& path, std::string_view text, Overwrite overwrite) {
    OutputFile file(path, overwrite);
    file.write(text);
    file.commit();
}

}  // namespace drillwave
