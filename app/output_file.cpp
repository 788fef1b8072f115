// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_file.h"

#include <QFile>
#include <QFileInfo>
#include <cstdio>

#include "app/command_error.h"
#include "ui/document/whole_file.h"

namespace drillwave {

namespace {

bool isStandardOutput(const std::string& path) {
    return path == "-";
}

/// Something like /dev/null or a pipe, which cannot be replaced by a file.
bool isDevice(const QFileInfo& info) {
    return info.exists() && !info.isFile() && !info.isDir();
}

}  // namespace

QString fileName(const std::string& path) {
    const QByteArray bytes = QByteArray::fromStdString(path);
    const QString name = QFile::decodeName(bytes);
    if (QFile::encodeName(name) != bytes)
        throw CommandError(
            ExitCode::unwritableOutput,
            name.toStdString() + ": the name has bytes that are not UTF-8; choose another one");
    return name;
}

void checkOverwrite(const std::string& path, Overwrite overwrite) {
    const QFileInfo info(fileName(path));
    if (isStandardOutput(path) || isDevice(info)) return;
    if (info.isDir())
        throw CommandError(ExitCode::unwritableOutput, path + ": is a folder; give the name of a file");
    // A dangling link exists too, as something that would be written through.
    if ((info.exists() || info.isSymLink()) && overwrite == Overwrite::refused)
        throw CommandError(ExitCode::unwritableOutput,
                           path + ": exists already; use --force to overwrite it or choose another name");
}

OutputFile::OutputFile(const std::string& path, Overwrite overwrite) : m_path(path) {
    checkOverwrite(path, overwrite);
    const QString name = fileName(path);
    bool open = false;
    if (isStandardOutput(path)) {
        auto file = std::make_unique<QFile>();
        open = file->open(stdout, QIODevice::WriteOnly | QIODevice::Unbuffered);
        m_file = std::move(file);
    } else if (isDevice(QFileInfo(name))) {
        m_file = std::make_unique<QFile>(name);
        open = m_file->open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    } else {
        m_file = std::make_unique<QSaveFile>(name);
        open = m_file->open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    }
    if (!open) fail();
}

void OutputFile::write(std::string_view text) {
    if (!writeAll(*m_file, text.data(), static_cast<qint64>(text.size()))) fail();
}

void OutputFile::flush() {
    if (!m_file->flush()) fail();
}

void OutputFile::commit() {
    // The C library holds the last bytes for standard output back, and would lose them without a word.
    flush();
    auto* saved = qobject_cast<QSaveFile*>(m_file.get());
    if (saved && !saved->commit()) fail();
}

void OutputFile::fail() const {
    const std::string name = isStandardOutput(m_path) ? "standard output" : m_path;
    throw CommandError(ExitCode::unwritableOutput,
                       name + ": cannot be written: " + m_file->errorString().toStdString() + "; " +
                           (isFull(*m_file) ? "free some space or " : "") + "choose another place with -o");
}

void writeFile(const std::string& path, std::string_view text, Overwrite overwrite) {
    OutputFile file(path, overwrite);
    file.write(text);
    file.commit();
}

}  // namespace drillwave
