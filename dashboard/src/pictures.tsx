// Small pictures of surfaces in tables: drawn when they come into sight, one after the other, all by one context of WebGL.

import { type BufferGeometry, OrthographicCamera, Scene, WebGLRenderer } from "three";
import { useEffect, useRef, useState } from "preact/hooks";
import { type Frame, frameOf } from "./pair";
import { useWork } from "./parts";
import { type Coloring, fit, lookAt, meshOf, paint } from "./surface";

/** What a picture shows; without a coloring all is gray, without a frame it is seen from its own flattest side. */
export interface Subject {
  geometry: BufferGeometry;
  coloring?: Coloring;
  frame?: Frame;
}

const [WIDTH, HEIGHT] = [84, 38];
const MOST_KEPT = 500;
/** How long a row is in sight before its picture is asked for: rows that are scrolled past are not. */
const IN_SIGHT_MS = 250;

let renderer: WebGLRenderer | null | undefined;
const kept = new Map<string, string>();
let turn: Promise<unknown> = Promise.resolve();

function drawn({ geometry, coloring, frame = frameOf(geometry) }: Subject): string | null {
  if (renderer === undefined) {
    try {
      renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
      renderer.setPixelRatio(2);
      renderer.setSize(WIDTH, HEIGHT, false);
    } catch {
      renderer = null;
    }
  }
  if (renderer === null) return null;
  const [mesh, scene, camera] = [meshOf(geometry), new Scene(), new OrthographicCamera()];
  if (coloring) paint(mesh, coloring);
  scene.add(mesh);
  lookAt(camera, frame, geometry.boundingSphere?.radius || 1);
  fit(camera, frame, WIDTH, HEIGHT);
  renderer.setClearColor(0, 0);
  renderer.render(scene, camera);
  mesh.material.uniforms.map!.value.dispose();
  mesh.material.dispose();
  geometry.dispose();
  return renderer.domElement.toDataURL();
}

/** A picture of what `load` gets, which is asked for once for each name. */
export function Picture({ name, alt, load }: { name: string; alt: string; load: (signal: AbortSignal) => Promise<Subject | null> }) {
  const box = useRef<HTMLSpanElement>(null);
  const [isSeen, setSeen] = useState(false);
  const [address, setAddress] = useState<string | null>(kept.get(name) ?? null);
  useEffect(() => {
    let timer = 0;
    const watch = new IntersectionObserver((entries) => {
      clearTimeout(timer);
      if (entries.at(-1)!.isIntersecting) timer = window.setTimeout(() => setSeen(true), IN_SIGHT_MS);
    });
    watch.observe(box.current!);
    return () => {
      clearTimeout(timer);
      watch.disconnect();
    };
  }, []);
  useWork(
    (signal) => {
      setAddress(kept.get(name) ?? null);
      if (!isSeen || kept.has(name)) return;
      turn = turn.then(async () => {
        if (signal.aborted) return;
        const found = await load(signal).catch(() => null);
        const made = found === null || signal.aborted ? null : drawn(found);
        if (made === null) return;
        if (kept.size >= MOST_KEPT) kept.clear();
        kept.set(name, made);
        setAddress(made);
      });
    },
    [name, isSeen],
  );
  return (
    <span class="picture" ref={box}>
      {address !== null && <img src={address} width={WIDTH} height={HEIGHT} alt={alt} />}
    </span>
  );
}
