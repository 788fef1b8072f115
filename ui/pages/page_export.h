// SPDX-License-Identifier: GPL-3.0-or-later
// An export of a page: numbers or a picture that can be written to a file.
#pragma once

#include <QByteArray>
#include <QString>
#include <functional>
#include <optional>

#include "ui/questions/picture_dialog.h"

namespace drillwave {

/// Export of a page, as numbers or as a picture. Its functions return what the page shows when they are
/// called.
struct PageExport {
    struct Picture {
        /// Function that returns the bytes of the file; empty if it cannot be drawn. `title` goes into the
        /// file's properties.
        std::function<QByteArray(const PictureChoice& choice, const QString& title)> file;
        /// Function that returns the width divided by the height of the picture on screen.
        std::function<double()> aspectRatio;
        std::function<void()> copy;  ///< copies the picture to the clipboard
    };

    QString title;    ///< text in the menu, such as "&Data of this plot…"
    QString toolTip;  ///< title as a sentence
    /// Suffix of the proposed file name after the scenario's name, such as "_plot"; may be empty.
    QString fileStem;
    std::function<QByteArray()> csv;
    /// Content that csv() returns: `rows`, which are saved below a header that describes the blow, or
    /// `wholeFile`, which is saved without a header.
    enum class Content { rows, wholeFile } content = Content::rows;
    /// Function that returns why the export is impossible now; empty if it is possible. May be nullptr, which
    /// means always possible.
    std::function<QString()> obstacle = {};
    std::optional<Picture> picture;  ///< picture to export instead of csv
};

}  // namespace drillwave
