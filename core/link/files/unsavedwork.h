// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "link/files/filewriter.h"

class QLockFile;

namespace nmc {

/// Keeps unsaved work in a separate file, so that neither a crash nor a careless close loses it. Each running
/// program has its own file; the next program finds what an ended one has left. Only construction and
/// destruction wait for the disk. GUI thread.
class UnsavedWork {
public:
    struct Left {
        QString file;      ///< the file it was to be saved to; may be empty
        QString fileHash;  ///< what is known of that file's content; may be empty
        std::string content;
    };

    /// `folder` is created if it does not exist.
    explicit UnsavedWork(const QString& folder, FileWriter::Disk disk = writeFile);
    ~UnsavedWork();
    UnsavedWork(const UnsavedWork&) = delete;
    UnsavedWork& operator=(const UnsavedWork&) = delete;

    /// Work left by another session; it is kept until dropLeft().
    [[nodiscard]] const std::optional<Left>& left() const { return m_left; }
    void dropLeft();

    /// Replaces what this session kept before; see Left. `done`: as in FileWriter.
    void keep(const QString& file, const QString& fileHash, const std::string& content,
              FileWriter::Done done);
    /// Called when everything is saved, or no longer wanted.
    void forget();

private:
    /// A file that only one program may use at a time.
    struct Slot {
        QString path;
        std::unique_ptr<QLockFile> lock;
    };
    enum class Wanted : std::uint8_t { Used, Free };
    [[nodiscard]] std::optional<Slot> takeSlot(int number, Wanted wanted) const;

    QString m_folder;
    std::optional<Slot> m_leftSlot;
    std::optional<Left> m_left;
    std::optional<Slot> m_own;
    FileWriter m_files;  ///< destroyed before the locks
};

}  // namespace nmc
