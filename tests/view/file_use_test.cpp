// What the open scene is made of is not written over, and is found again from wherever the scene is kept.
#include "fixtures.h"
#include "text/file.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string bytes_of(const std::string& path) { return read_file(path, 1 << 20).value(); }

/// A scene in a folder of its own, with a mesh beside it.
State mesh_state(const TemporaryFolder& folder) {
  fs::create_directories(folder.file("from"));
  fs::create_directories(folder.file("to"));
  REQUIRE(write_file_atomically(folder.file("from/m.ply"), ply));
  REQUIRE(write_file_atomically(folder.file("from/s.toml"),
                                "[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n"
                                "[[object]]\nname = \"M\"\ntype = \"mesh\"\nfile = \"m.ply\"\n"
                                "[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"));
  return make_state(read_document(folder.file("from/s.toml")), folder.file("from/s.toml"), folder.file("state"));
}

void check_refused(State& state) {
  CHECK_FALSE(state.document.question);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK_THAT(state.document.notice->text, contains("cannot write: this") && contains("in use"));
  state.document.notice.reset();
}

}  // namespace

TEST_CASE("nothing that is saved or exported replaces a part of the open scene") {
  const TemporaryFolder folder;
  State state = mesh_state(folder);
  fs::create_symlink("m.ply", folder.file("from/soft.toml"));
  fs::create_hard_link(folder.file("from/m.ply"), folder.file("from/hard.svg"));
  fs::create_symlink("s.toml", folder.file("from/scene.html"));
  REQUIRE(write_file_atomically(folder.file("show.txt"), "step\n"));
  state.document.keeps = {folder.file("show.txt")};
  update(state, action::SaveAs{folder.file("from/soft.toml")});
  check_refused(state);
  for (const char* name : {"from/hard.svg", "from/scene.html", "show.txt"}) {
    CAPTURE(name);
    update(state, action::Export{folder.file(name)});
    check_refused(state);
  }
  CHECK(bytes_of(folder.file("from/m.ply")) == ply);
  CHECK(bytes_of(folder.file("show.txt")) == "step\n");
  // Over itself a scene is saved without a question, over another file with one.
  update(state, action::SaveAs{folder.file("from/s.toml")});
  CHECK_FALSE(state.document.question);
  REQUIRE(write_file_atomically(folder.file("to/other.toml"), "x"));
  update(state, action::SaveAs{folder.file("to/other.toml")});
  CHECK(state.document.question);
}

TEST_CASE("a scene that is saved into another folder finds its mesh again, and so does what follows") {
  const TemporaryFolder folder;
  State state = mesh_state(folder);
  make_dirty(state);
  update(state, action::SaveAs{folder.file("to/s.toml")});
  CHECK_THAT(bytes_of(folder.file("to/s.toml")), contains("file = \"../from/m.ply\""));
  CHECK(read_document(folder.file("to/s.toml")).files.size() == 2);
  update(state, action::Undo{});
  update(state, action::Save{});
  CHECK_THAT(bytes_of(folder.file("to/s.toml")), contains("file = \"../from/m.ply\""));
  CHECK(read_document(folder.file("to/s.toml")).files.size() == 2);
  // The file that it came from is free now.
  update(state, action::SaveAs{folder.file("from/s.toml")});
  REQUIRE(state.document.question);
  update(state, action::AnswerQuestion{action::Answer::save});
  CHECK_THAT(bytes_of(folder.file("from/s.toml")), contains("file = \"m.ply\""));
}

TEST_CASE("an autosave finds the scene's mesh from its own folder, and takes it home") {
  const TemporaryFolder folder;
  State state = mesh_state(folder);
  make_dirty(state);
  for (int i = 0; i < 8; ++i) update(state, action::Tick{1});
  crash(state);
  State next = make_state(read_document(folder.file("from/s.toml")), folder.file("from/s.toml"), folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  update(next, action::AnswerQuestion{action::Answer::recover});
  CHECK(next.scene() == state.scene());
  CHECK(next.document.dirty);
  update(next, action::Save{});
  CHECK_THAT(bytes_of(folder.file("from/s.toml")), contains("file = \"m.ply\""));
}
