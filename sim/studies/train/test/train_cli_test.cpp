// SPDX-License-Identifier: Apache-2.0
// train_cli_test: `pipegs train` as a person meets it: what it writes, what it refuses, and what is left after an
// interrupt, a kill and a full disk.
#include <glm/gtc/quaternion.hpp>
#include <tuple>

#include "cpp_model/float/truth.hpp"
#include "verif/cli/cli.hpp"
#include "verif/scenes/colmap_file.hpp"
#include "sim/studies/train/test/small_world.hpp"

namespace pipegs {
namespace {

class TrainCli : public Cli {
 protected:
  // photos: nine photographs of a small scene as COLMAP would leave them. scene.ply, cameras.json: the scene itself.
  void SetUp() override {
    Cli::SetUp();
    const Scene scene = small_scene(60);
    const std::vector<Camera> cameras = small_cameras(9, 40, 30);
    write_ply(folder_ / "scene.ply", scene);
    write_cameras(folder_ / "cameras.json", cameras);
    ColmapModel model;
    model.parameters = {cameras[0].fx, cameras[0].fy, 20, 15};
    model.poses.clear();
    for (const Camera& camera : cameras) {
      const glm::dquat q = glm::quat_cast(camera.world_to_camera);
      model.poses.push_back({static_cast<std::uint32_t>(camera.id) + 1,
                             7,
                             {q.w, q.x, q.y, q.z},
                             -(camera.world_to_camera * camera.position),
                             camera.name + ".png"});
    }
    model.points = small_points(scene);
    model.write(folder_ / "photos");
    for (const Camera& camera : cameras)
      write_png(folder_ / "photos/images" / (camera.name + ".png"), render_truth(scene, camera, {}), glm::dvec3(0));
  }

  Json report(const std::string& out) { return Json::parse(text(out + "/train.json")); }
};

TEST_F(TrainCli, PhotographsBecomeASceneAndItsCameras) {
  const Outcome outcome = run("train photos --steps 220 --layers 4 --max-gaussians 90 --out a/b");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "progress is for a terminal";
  const Scene scene = read_ply(folder_ / "a/b/scene.ply");
  EXPECT_GT(scene.gaussians.size(), 60u);
  EXPECT_LE(scene.gaussians.size(), 90u);
  EXPECT_EQ(scene.sh_degree, 3);
  const std::vector<Camera> cameras = read_cameras(folder_ / "a/b/cameras.json"),
                            held_out = read_cameras(folder_ / "a/b/held_out.json"),
                            wanted = read_cameras(folder_ / "cameras.json");
  ASSERT_EQ(cameras.size(), 9u);
  ASSERT_EQ(held_out.size(), 2u);
  EXPECT_EQ(held_out[1].name, "view108.png");
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    EXPECT_LT(glm::length(cameras[i].position - wanted[i].position), 1e-9);
    EXPECT_EQ(cameras[i].cx, wanted[i].cx);
  }
  const Json json = report("a/b");
  EXPECT_EQ(json["steps"], 220);
  EXPECT_EQ(json["gaussians"], scene.gaussians.size());
  EXPECT_EQ(json["options"]["order"], "layered");
  EXPECT_EQ(json["options"]["cldr"], "logarithm");
  EXPECT_EQ(json["measured_layers"], 4);
  EXPECT_EQ(json["views"], Json({{"trained", 7}, {"held_out", 2}}));
  EXPECT_GT(json["held_out"]["exact"]["psnr_db"], 17);
  EXPECT_LT(json["held_out"]["layered"]["ssim"], 1);
  // The machines draw what the truth draws, dop in layers and fast in exact order, up to their numbers.
  const Json& machines = json["held_out"]["machines"];
  for (const auto& [machine, order] : {std::pair{"dop", "layered"}, {"fast", "exact"}}) {
    const double truth = json["held_out"][order]["psnr_db"];
    EXPECT_NEAR(machines[machine]["psnr_db"].get<double>(), truth, 0.05) << machine;
    EXPECT_GT(machines[machine]["cycles"], 100) << machine;
  }
  ASSERT_EQ(json["held_out"]["views"].size(), 2u);
  EXPECT_EQ(json["held_out"]["views"][1]["camera"], "view108.png");
  const double views = json["held_out"]["views"][0]["dop"]["psnr_db"].get<double>() +
                       json["held_out"]["views"][1]["dop"]["psnr_db"].get<double>();
  EXPECT_NEAR(views / 2, machines["dop"]["psnr_db"].get<double>(), 1e-9);
  EXPECT_EQ(json["held_out"]["violators"].size(), 3u);
  EXPECT_FALSE(json.contains("held_out_before"));
  EXPECT_NE(outcome.out.find("exact order "), std::string::npos) << outcome.out;
  // What was trained can be drawn.
  EXPECT_EQ(run("render a/b/scene.ply --cameras a/b/held_out.json --model truth --out picture").code, 0);
}

TEST_F(TrainCli, ASceneIsFineTuned) {
  const Outcome outcome = run("train scene.ply --cameras cameras.json --steps 150 --layers 4 --downscale 2 --out fine");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_ply(folder_ / "fine/scene.ply").gaussians.size(), 60u);
  EXPECT_EQ(read_cameras(folder_ / "fine/cameras.json")[0].width, 20);
  const Json json = report("fine");
  EXPECT_EQ(json["fine_tuning"], true);
  EXPECT_EQ(json["options"]["cldr"], "none");
  EXPECT_GT(json["held_out"]["layered"]["psnr_db"], 25);
  EXPECT_LT(json["held_out_before"]["layered"]["psnr_db"], json["held_out_before"]["exact"]["psnr_db"]);
  EXPECT_GT(json["held_out_before"]["exact"]["psnr_db"], 60) << "its pictures are its own";
}

TEST_F(TrainCli, ViewsAreThoseOfAnOrbitOrAroundThose) {
  const Outcome orbit = run("train scene.ply --orbit 9 --size 40x30 --steps 2 --json --out orbit");
  ASSERT_EQ(orbit.code, 0) << orbit.err;
  EXPECT_EQ(Json::parse(orbit.out), report("orbit"));
  EXPECT_EQ(report("orbit")["views"], Json({{"trained", 7}, {"held_out", 2}}));
  const Outcome around = run("train scene.ply --size 40x30 --around 9 --steps 2 --out around");
  ASSERT_EQ(around.code, 0) << around.err;
  EXPECT_EQ(report("around")["views"], Json({{"trained", 8}, {"held_out", 2}}));
  const Json measured = report("around")["held_out"]["views"];  // those held out, and the view that was framed
  ASSERT_EQ(measured.size(), 3u);
  EXPECT_EQ(measured[0]["camera"].get<std::string>().rfind("around_", 0), 0u);
  EXPECT_EQ(measured[1]["held_out"], true);
  EXPECT_EQ(measured[2]["held_out"], false);
}

TEST_F(TrainCli, KilledAndResumedItIsTheSameScene) {
  const std::string train = "train photos --steps 300 --layers 2 --seed 5 --max-gaussians 80 --checkpoint-every 7 ";
  ASSERT_EQ(run(train + "--out whole").code, 0);
  const std::string wanted = text("whole/scene.ply");
  const std::string pipegs = "'" PIPEGS_BINARY "' ";
  // Killed as soon as there is a checkpoint; another one interrupted; then the first one goes on.
  const std::string killed = shell(pipegs + train +
                                   "--out cut --threads 1 & p=$!\n"
                                   "until [ -e cut/checkpoint.bin ]; do sleep 0.01; done; kill -KILL $p; wait $p")
                                 .err;
  const std::string before = text("cut/checkpoint.bin");
  ASSERT_FALSE(before.empty()) << killed;
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome stopped =
        shell(pipegs + "train photos --steps 100000 --checkpoint-every 7 --out " + signal + " & p=$!\nuntil [ -e " +
              signal + "/checkpoint.bin ]; do sleep 0.01; done; kill -" + signal + " $p; wait $p");
    expect_one_line(stopped, 130, "interrupted after step ");
    EXPECT_NE(stopped.err.find("--resume goes on from"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / signal / "scene.ply"));
  }
  ASSERT_EQ(run(train + "--out cut --resume").code, 0);
  EXPECT_TRUE(text("cut/scene.ply") == wanted);
  // Done is done: the same again, and not a step more.
  fs::remove(folder_ / "cut/scene.ply");
  ASSERT_EQ(run(train + "--out cut --resume").code, 0);
  EXPECT_TRUE(text("cut/scene.ply") == wanted);
}

TEST_F(TrainCli, ABrokenCheckpointIsRefusedAndStays) {
  const std::string train = "train photos --steps 20 --out kept ";
  ASSERT_EQ(run(train).code, 0);
  const std::string good = text("kept/checkpoint.bin");
  expect_refused(train + "--resume --seed 2", "kept/checkpoint.bin: it is of another run");
  write("kept/checkpoint.bin", good.substr(0, good.size() - 100));
  expect_refused(train + "--resume", "kept/checkpoint.bin: the checksum is wrong");
  EXPECT_EQ(text("kept/checkpoint.bin").size(), good.size() - 100);
}

TEST_F(TrainCli, AFullDiskLeavesTheCheckpointBefore) {
  ASSERT_EQ(run("train photos --steps 20 --out kept").code, 0);
  const std::string good = text("kept/checkpoint.bin"), scene = text("kept/scene.ply");
  expect_one_line(run("train photos --steps 20 --seed 9 --out kept", "trap '' XFSZ; ulimit -f 8; "), 3, "cannot write");
  EXPECT_TRUE(text("kept/checkpoint.bin") == good);
  EXPECT_TRUE(text("kept/scene.ply") == scene);
  EXPECT_EQ(run("train photos --steps 20 --out kept --resume").code, 0);
}

TEST_F(TrainCli, BadUseIsToldInOneLine) {
  expect_refused("train nowhere --cameras cameras.json", "nowhere: cannot open: found no file");
  expect_refused("train scene.ply", "found one view, expected at least two, of which one is held out: --cameras, ");
  for (const char* views : {"--cameras cameras.json", "--orbit 9", "--around 1"})
    expect_refused(std::string("train photos ") + views, "found one with a folder of photographs, expected none");
  expect_refused("train photos --layers 3", "--layers: found 3, expected 0 for none, or 2, 4 or 8");
  expect_refused("train photos --steps 0", "--steps: found '0'");
  expect_refused("train photos --cldr relative", "--cldr: relative not in {logarithm,printed,none}");
  expect_refused("train photos --out scene.ply", "--out 'scene.ply': cannot be written");
  fs::create_directory(folder_ / "empty");
  expect_refused("train empty", "empty: found no folder sparse/0");
  EXPECT_FALSE(fs::exists(folder_ / "trained")) << "something was left behind";
}

// A camera that the machines cannot draw, held out or trained, is told before the first step.
TEST_F(TrainCli, CamerasAreTriedBeforeTheFirstStep) {
  const Json cameras = Json::parse(text("cameras.json"));
  for (const auto& [view, field, value] :
       {std::tuple{0, "cx", 1e300}, {3, "cx", -1e300}, {4, "fx", 1e-300}, {8, "fy", 1e300}}) {
    Json wrong = cameras;
    wrong[static_cast<std::size_t>(view)][field] = value;
    write("wrong.json", wrong.dump());
    expect_one_line(run("train scene.ply --cameras wrong.json --steps 1000000 --out out"), 2, "camera '");
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(TrainCli, BadInputIsToldInOneLine) {
  write_cameras(folder_ / "one.json", small_cameras(1));
  expect_refused("train scene.ply --cameras one.json", "one.json: found one view, expected at least two");
  Scene scene = small_scene(5);
  scene.antialiased = true;
  write_ply(folder_ / "soft.ply", scene);
  expect_refused("train soft.ply --cameras cameras.json", "soft.ply: found an antialiased scene");
  scene.antialiased = false;
  scene.gaussians.clear();
  write_ply(folder_ / "none.ply", scene);
  expect_refused("train none.ply --cameras cameras.json", "none.ply: found no Gaussian that can be drawn");
  fs::rename(folder_ / "photos/images/view103.png", folder_ / "gone.png");
  expect_refused("train photos", "image 'view103.png': found no photograph of this name");
  write("photos/images/view103.png", text("gone.png").substr(0, 300));
  expect_refused("train photos", "view103.png: cannot read");
  write_png8(folder_ / "photos/images/view103.png", {40, 20, std::vector<std::uint8_t>(40 * 20 * 3)});
  expect_refused("train photos", "view103.png: found 40x20 pixels, expected 40x30");
  EXPECT_FALSE(fs::exists(folder_ / "trained")) << "something was left behind";
}

}  // namespace
}  // namespace pipegs
