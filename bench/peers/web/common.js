// What both pages share: what they are asked for, how frames are timed, how pictures leave the page.

/** So white that a surface that faces the sun stays just below it: the sun's light, and that of all around. */
export const SUN = 2.6;
export const AMBIENT = 0.18;
/** Frames that are drawn after a change and not counted. */
const SETTLE = 4;

/** The page's question, with the camera and the sun that it is about. */
export async function question() {
  const words = new URLSearchParams(location.search);
  const number = (name) => Number(words.get(name));
  const views = await (await fetch(words.get("cameras"))).json();
  const wanted = words.get("camera");
  const camera = views.cameras[Number(wanted)] ?? views.cameras.find(({ name }) => name === wanted);
  if (!camera) throw new Error(`there is no camera ${wanted} among ${views.cameras.length}`);
  if (!camera.fov_y_degrees) throw new Error(`camera ${wanted} sees by parallel rays, which this page does not`);
  const sun = words.get("sun")?.split(",").map(Number) ?? views.lights.find(({ kind }) => kind === "sun")?.direction;
  if (!sun) throw new Error("the world has no sun; give one with --sun X,Y,Z");
  return {
    scene: words.get("scene"),
    width: number("width"),
    height: number("height"),
    maps: number("maps"),
    resolution: number("resolution"),
    frames: number("frames"),
    batches: number("batches"),
    camera,
    sun,
  };
}

/**
 * Times a batch of frames: the mean of one, milliseconds. `draw` draws one, and returns what resolves when it is done. Two
 * are in flight, as in a window: each is waited for while the next is drawn.
 */
async function batch(draw, frames) {
  for (let i = 0; i < SETTLE; i++) await draw();
  let last = draw();
  const done = [];
  for (let i = 0; i < frames; i++) {
    const next = draw();
    await last;
    done.push(performance.now());
    last = next;
  }
  await last;
  done.push(performance.now());
  return (done.at(-1) - done[0]) / frames;
}

/**
 * Runs the page. A `peer` draws (`draw`), switches shadows and the sun's strength (`light(shadows, sun)`), and says what it
 * is (`about`). The answer, and what went wrong, is left for the runner.
 */
export async function run(make) {
  try {
    const asked = await question();
    const canvas = document.querySelector("canvas");
    [canvas.width, canvas.height] = [asked.width, asked.height];
    const peer = await make(canvas, asked);
    const milliseconds = { no_shadows: [], shadows: [] };
    for (let i = 0; i < asked.batches; i++) {
      for (const [name, shadows] of [["no_shadows", false], ["shadows", true]]) {
        peer.light(shadows, SUN);
        milliseconds[name].push(await batch(peer.draw, asked.frames));
      }
    }
    // In the turn that draws, since what is shown is given up afterwards.
    window.picture = async (shadows, sun) => {
      peer.light(shadows, sun * SUN);
      for (let i = 0; i < SETTLE; i++) await peer.draw();
      const drawn = peer.draw();
      const url = canvas.toDataURL("image/png");
      await drawn;
      return url.split(",")[1];
    };
    const { width, height, maps, resolution, frames } = asked;
    window.answer = { ...peer.about(), width, height, maps, resolution, frames_a_batch: frames, milliseconds };
  } catch (why) {
    window.answer = { failed: String(why?.stack ?? why) };
  }
}
