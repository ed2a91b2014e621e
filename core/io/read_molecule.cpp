#include "core/io/read_molecule.hpp"

#include "core/io/readers.hpp"
#include "core/io/sniff_format.hpp"
#include "core/io/text_file.hpp"

namespace alphascope {

Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options,
                       const RunContext& context) {
  const LoadedText loaded = load_text(path, options.max_bytes, context);
  const ReaderInput input{path, loaded.text, context};
  switch (sniff_format(path, loaded.text)) {
    case FileFormat::pdb:
      return read_pdb(input);
    case FileFormat::mmcif:
      return read_mmcif(input);
    case FileFormat::ball_table:
      return read_ball_table(input);
    case FileFormat::unknown:
      break;
  }
  throw ReadError(
      path, 0,
      "this is no molecule file that can be read: it looks like " + describe_unknown(loaded.text),
      "Formats that can be opened: PDB, mmCIF, XYZR and CRD (x y z r), also packed as .gz");
}

}  // namespace alphascope
