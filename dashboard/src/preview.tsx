// One surface to turn, with a mark at the place of a fault.

import { Color, DirectionalLight, DoubleSide, HemisphereLight, Mesh, MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, Scene, SphereGeometry, Vector3, WebGLRenderer } from "three";
import { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
import { useEffect, useRef, useState } from "preact/hooks";
import { frameOf, readPly } from "./pair";
import { useShownTheme } from "./parts";

export function Preview({ ply, fault, name }: { ply: ArrayBuffer; fault: [number, number, number] | null; name: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = useShownTheme();
  const [failure, setFailure] = useState<string | null>(null);
  useEffect(() => {
    const element = canvas.current!;
    let renderer: WebGLRenderer;
    try {
      renderer = new WebGLRenderer({ canvas: element, antialias: true });
    } catch {
      setFailure("This browser cannot draw in 3D.");
      return;
    }
    const { geometry } = readPly(ply);
    const frame = frameOf(geometry);
    const radius = geometry.boundingSphere?.radius || 1;
    const scene = new Scene();
    const surface = new Mesh(geometry, new MeshLambertMaterial({ color: 0x8fb4d9, side: DoubleSide }));
    scene.add(surface, new HemisphereLight(0xffffff, 0x8899aa, 1.4));
    const light = new DirectionalLight(0xffffff, 1.6);
    scene.add(light);
    if (fault) {
      const mark = (size: number, opacity: number) => {
        const ball = new Mesh(new SphereGeometry(radius * size, 24, 16), new MeshBasicMaterial({ color: 0xd6006c, transparent: true, opacity, depthTest: false }));
        ball.position.set(...fault);
        ball.renderOrder = 1;
        scene.add(ball);
      };
      mark(0.03, 1);
      mark(0.1, 0.35);
    }
    renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    const camera = new OrthographicCamera(-1, 1, 1, -1, -20 * radius, 40 * radius);
    const [first, second, third] = frame.axes;
    camera.up.copy(second);
    // From the side on which the fault is.
    const toward = fault && new Vector3(...fault).sub(frame.center).dot(third) < 0 ? -4 : 4;
    camera.position.copy(frame.center).addScaledVector(third, toward * radius).addScaledVector(first, 0.0001);
    camera.lookAt(frame.center);
    const controls = new TrackballControls(camera, element);
    controls.target.copy(frame.center);
    controls.staticMoving = true;
    controls.rotateSpeed = 3;
    let isDirty = true;
    controls.addEventListener("change", () => (isDirty = true));
    const resize = () => {
      const { clientWidth: width, clientHeight: height } = element;
      if (width === 0) return;
      renderer.setSize(width, height, false);
      const half = Math.max((1.1 * Math.max(-frame.low.x, frame.high.x)) / width, (1.2 * Math.max(-frame.low.y, frame.high.y)) / height) || radius / height;
      [camera.left, camera.right, camera.top, camera.bottom] = [-half * width, half * width, half * height, -half * height];
      camera.updateProjectionMatrix();
      controls.handleResize();
      isDirty = true;
    };
    const sizes = new ResizeObserver(resize);
    sizes.observe(element);
    let waiting = 0;
    const loop = () => {
      waiting = requestAnimationFrame(loop);
      controls.update();
      if (!isDirty) return;
      isDirty = false;
      light.position.copy(camera.position).sub(frame.center);
      renderer.setClearColor(new Color(getComputedStyle(element).getPropertyValue("--canvas").trim() || "#f4f6f8"));
      renderer.render(scene, camera);
    };
    resize();
    loop();
    return () => {
      cancelAnimationFrame(waiting);
      sizes.disconnect();
      controls.dispose();
      geometry.dispose();
      renderer.dispose();
    };
  }, [ply, fault?.join(), theme]);
  return failure === null ? <canvas class="preview" ref={canvas} role="img" aria-label={`The ${name} surface${fault ? ", the place of the fault is marked" : ""}`} /> : <p class="failure">{failure}</p>;
}
