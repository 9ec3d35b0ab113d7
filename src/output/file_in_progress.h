// SPDX-License-Identifier: Apache-2.0
#pragma once
// A file that is complete or not there.
#include "image/strip_encoder.h"

namespace glint {

/// A file while it is written. Its functions may throw.
class FileInProgress : public ByteFile {
  public:
    /// Ends the file. If this is not called, there is no file. durable: returns when the bytes are on the
    /// disk.
    virtual void commit(bool durable) = 0;
};

}  // namespace glint
