var Lt,yp,Ax,Ws,bh,Rl,bp,Tl,Sp,Mh,Sh,Ex,la=Symbol.for("pv"),Pl={},Il=[],Cx=/^m(i|n|o|s|text|space)$/,wh=Array.isArray,Mp=Il.slice,_r=Object.assign;function gr(n){n&&n.parentNode&&n.remove()}function Al(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:la,__v:s||++yp,__i:-1,__u:0};return!s&&Lt.vnode&&Lt.vnode(r),r}function _n(n){return n.children}function El(n,e){this.props=n,this.context=e,this.__g=0}function Xs(n,e){if(e==null)return n.__&&Xs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Xs(n)}function Rx(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=_r({constructor:la},t)).__v=t.__v+1,Lt.vnode&&Lt.vnode(e),Th(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Xs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Rp(s,e,r),t.__=t.__e=null,e.__e!=i&&wp(e))}function wp(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),wp(n)}function xp(n){(8&n.__g||(n.__g|=8,Ws.push(n),Rl++))&&bh==Lt.debounceRendering||((bh=Lt.debounceRendering)||queueMicrotask)(Tp)}function Tp(){try{for(var n,e=1;Ws.length;)Ws.length>e&&Ws.sort(bp),n=Ws.shift(),e=Ws.length,8&n.__g&&Rx(n)}finally{(Rl=Ws.length)&&(bh||queueMicrotask)(Tp)}}function Ap(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,_,v,p,g=i.__k||Il,x=e.length;for(l=Px(t,e,g,l,x),h=0;h<x;h++)(d=t.__k[h])!=null&&(f=~d.__i&&g[d.__i]||Pl,d.__i=h,p=Th(n,d,f,s,r,o,a,l,c,u),_=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&Ah(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||_,d)),v=v||_,4&d.__u?(l=Ep(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&p!==void 0?l=p:_&&(l=_.nextSibling),d.__u&=-21);return t.__e=v,l}function Px(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,_=t.length,v=_,p=0,g=0,x=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[r]=Al(null,o):wh(o)?o=x[r]=Al(_n,{children:o}):o.constructor===la&&o.__b?o=x[r]=Al(o.type,o.props,o.key,o.ref,o.__v):x[r]=o,l=r+p,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Ix(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?p--:c==l+1?p++:c!=l&&(c>l?p--:p++,g=1)):(~c||(s>_?p--:s<_&&p++),typeof o.type!="function"&&(o.__u|=4))):x[r]=null;if(g){for(u=[],h=[],r=0;r<s;r++)if((o=x[r])&&16&o.__u){for(p=0,f=u.length;p<f;)u[d=p+f>>1]<o.__i?p=d+1:f=d;u[p]=o.__i,h[r]=p+1}for(p=u.length;r--;)h[r]&&(h[r]==p?p--:x[r].__u|=4)}if(v)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Xs(a)),Eh(a,a));return i}function Ep(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Ep(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Xs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Ix(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function vp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function wl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||vp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||vp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Sh[e]||(Sh[e]=Lx(e)),(n.__a||(n.__a={}))[e]=Mh,r=e!=(e=e.replace(Sp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Lx(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Tl]==null)e[Tl]=Mh++;else if(e[Tl]<this.__a[n])return;return t(Lt.event?Lt.event(e):e)}}}function Th(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,_,v,p,g,x,M,b,y,S,m,w,I,P,L,N=e.type;if(e.constructor!==la)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=Cl(u,r):r.push(u),a=r[0]||a),(u=Lt.__b)&&u(e);e:if(typeof N=="function"){f=o.length;try{if(g=e.props,x=(u=N.prototype)&&u.render,M=(u=N.contextType)&&i[u.__c],b=u?M?M.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(x?e.__c=d=new N(g,b):(e.__c=d=new El(g,b),d.constructor=N,d.render=Nx),M&&M.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),x&&(d.__s||(d.__s=d.state),N.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=_r({},d.__s)),_r(d.__s,N.getDerivedStateFromProps(g,d.__s)))),_=d.props,v=d.state,d.__v=e,t.__c){if(g!==_&&x&&!N.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(g,b),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(g,d.__s,b)===!1){e.__v!=t.__v&&(d.props=g,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(B){B&&(B.__=e)}),Il.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Xs(t);break e}d.componentWillUpdate&&d.componentWillUpdate(g,d.__s,b),x&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(_,v,p)})}else x&&!N.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),x&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=b,d.props=g,d.__P=n,d.__g&=-5,y=Lt.__r,S=x?25:0;do d.__g&=-9,y&&y(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++S<25);x&&(Il.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=_r({},i,d.getChildContext())),x&&t.__c&&d.getSnapshotBeforeUpdate&&(p=d.getSnapshotBeforeUpdate(_,v)),m=u&&u.type===_n&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(B){B&&Eh(B,B)}),t.__k=null),a=t.__k?Xs(t,0):null),a=Ap(n,wh(m)?m:[m],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(gr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(B){if(o.length=f,e.__v=null,l||r)if(B&&B.then){if(e.__u|=128|l,r){for(~(P=r.indexOf(a||void 0))||(P=r.length);(L=r[P-1])&&L.nodeType==8;)P--;for(;P<r.length;P++)if(L=r[P])if(r[P]=null,w){if(L==I)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(I=Cl(w=L))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=Cl(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(gr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),B&&B.then||Cp(e),Lt.__e(B,e,t)}}else a=e.__e=Dx(t.__e,e,t,i,s,r,o,l,c,n);return(u=Lt.diffed)&&u(e),a}function Cl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Cp(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Cp))}function Rp(n,e,t){for(var i=0;i<t.length;)Ah(t[i++],t[i++],t[i++]);Lt.__c&&Lt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Lt.__e(r,s.__v)}})}function Dx(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,_,v,p,g,x=t.props||Pl,M=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(b?_.localName==b:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!b)return g.createTextNode(M);n=g.createElementNS(s,b,M.is?M:c),a&&(Lt.__m&&Lt.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&M.defaultValue!=null?null:r&&Mp.call(c.childNodes),!a&&r)for(x={},u=0;u<n.attributes.length;u++)x[(_=n.attributes[u]).name]=_.value;for(u in x)_=x[u],u=="dangerouslySetInnerHTML"?f=_:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||wl(n,u,null,_,s);for(u in M)_=M[u],u=="children"?d=_:u=="dangerouslySetInnerHTML"?h=_:u=="value"?v=_:u=="checked"?p=_:a&&typeof _!="function"||x[u]===_||wl(n,u,_,x[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Cx.test(b))&&(s="http://www.w3.org/1999/xhtml"),Ap(c,wh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Xs(t,0),a,l),r&&r.some(gr)),a&&b!="textarea"||(u="value",b=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(b!="progress"||v)||wl(n,u,v,x[u],s),u="checked",p!=null&&p!=n[u]&&wl(n,u,p,x[u],s))}else x===M||a&&n.data==M||(n.data=M);return n}function Ah(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Lt.__e(s,t)}}function Eh(n,e,t){var i,s,r,o;if(Lt.unmount&&Lt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Ah(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Lt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Eh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Cl(i,r=[]))&&(i==n.__e&&r.some(gr),gr(s),gr(i)),t||gr(n.__e),n.__e=n.__c=n.__=null}function Nx(n,e,t){return this.constructor(n,t)}function Pp(n,e){var t,i,s,r;Lt.__&&Lt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Al(_n,{children:[n]}),s=[],r=[],Th(e,e.__k,i||Pl,Pl,e.namespaceURI,i?null:e.firstChild?Mp.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Rp(s,e.__k,r),e.__k.props.children=null}Lt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Rl=0,n}},yp=0,Ax=function(n){return n!=null&&n.constructor===la},El.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=_r({},this.state)),typeof n=="function"&&(n=n(_r({},t),this.props)),n&&(_r(t,n),this.__v&&(e&&this.__k.push(e),xp(this)))},El.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),xp(this))},El.prototype.render=_n,Ws=[],Rl=0,bp=function(n,e){return n.__v.__b-e.__v.__b},Tl=Symbol(),Sp=/(PointerCapture)$|Capture$/i,Mh=0,Sh={},Ex=0;var ua,xn,Ch,Ip,Rh=Object.is,Ll=0,zp=[],Ph=[],fn=Lt,Lp=fn.__b,Dp=fn.__r,Np=fn.diffed,Op=fn.__c,Fp=fn.unmount,Up=fn.__;function Lh(n,e){fn.__h&&fn.__h(xn,n,Ll||e),Ll=0;var t=xn.__H||(xn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Oe(n){return Ll=1,Ox(Gp,n)}function Ox(n,e,t){var i=Lh(ua++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Gp(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Rh(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=xn,!xn.__f)){xn.__f=!0;var s=xn.shouldComponentUpdate;xn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,Rh(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Ft(n,e){var t=Lh(ua++,3);!fn.__s&&Vp(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,xn.__H.__h.push(t))}function Jn(n){return Ll=5,yi(function(){return{current:n}},[])}function yi(n,e){var t=Lh(ua++,7);return Vp(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Fx(){var n;do{for(;n=Ph.shift();)try{ca(n)}catch(t){fn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=zp.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ca),e.__h.some(Ih),e.__h=[]}catch(t){e.__h=[],fn.__e(t,n.__v)}}}while(Ph.length)}fn.__b=function(n){xn=null,Lp&&Lp(n)},fn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Up&&Up(n,e)},fn.__r=function(n){Dp&&Dp(n),ua=0;var e=(xn=n.__c).__H;e&&(Ch==xn?xn.__h=[]:(e.__h.some(ca),e.__h.some(Ih),ua=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Ch=xn},fn.diffed=function(n){Np&&Np(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&kp(zp.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Ch=xn=null},fn.__c=function(n,e){e.some(function(t){try{t.__h.some(ca),t.__h=t.__h.filter(function(i){return!i.__||Ih(i)})}catch(i){t.__h=[function(){throw i}]}}),Op&&Op(n,e)},fn.unmount=function(n){Fp&&Fp(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,kp(Ph.push(s))}else ca(s)}catch(r){e=r}}),i.__H=void 0,e&&fn.__e(e,i.__v))};var Bp=typeof requestAnimationFrame=="function";function Ux(n){var e,t=function(){clearTimeout(i),Bp&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Bp&&(e=requestAnimationFrame(t))}function kp(n){n!=1&&Ip==fn.requestAnimationFrame||((Ip=fn.requestAnimationFrame)||Ux)(Fx)}function ca(n){var e=xn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),xn=e}function Ih(n){var e=xn;n.__c=n.__(),xn=e}function Vp(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Rh(t,n[i])})}function Gp(n,e){return typeof e=="function"?e(n):e}var Nl=["queued","running","succeeded","failed","cancelled","expired","dead"],ha=n=>n.phase==="displacement"&&n.energy!==void 0,Oi=class extends Error{constructor(t){super(t.detail??t.title);this.problem=t}problem},Dh="homolog-key",Dl=[],to={get:()=>sessionStorage.getItem(Dh),set(n){n===null?sessionStorage.removeItem(Dh):sessionStorage.setItem(Dh,n)}};function Hp(n){return Dl.push(n),()=>{Dl=Dl.filter(e=>e!==n)}}var Nh=n=>new URL(n,document.baseURI.split("#")[0]);async function bi(n,e={}){let t=new Headers(e.headers),i=to.get();i!==null&&t.set("authorization",`Bearer ${i}`);let s=await fetch(Nh(n),{...e,headers:t,cache:e.cache??"no-cache"});if(s.status===401&&Dl.forEach(o=>o()),s.ok||s.status===304)return s;let r={type:"about:blank",title:s.statusText,status:s.status};try{r=await s.json()}catch{}throw new Oi(r)}async function Ut(n,e){return(await bi(n,{signal:e})).json()}async function is(n,e,t){let i={method:n};return t!==void 0&&(i.body=JSON.stringify(t),i.headers={"content-type":"application/json"}),(await bi(e,i)).json()}async function Wp(n,e){Oh(await(await bi(n)).blob(),e)}function Oh(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function qs(n){let e=Object.entries(n).filter(([,i])=>i!=null&&i!==""),t=new URLSearchParams(e.map(([i,s])=>[i,String(s)])).toString();return t===""?"":`?${t}`}var Rn=n=>{if(n instanceof Oi){let e=n.problem.errors?.map(t=>`${t.pointer}: ${t.detail}`).join("; ");return[n.problem.title,n.problem.detail,e].filter(Boolean).join(": ")}return n instanceof TypeError?"The service cannot be reached.":String(n)};function $e(n,e=3){return n==null||!Number.isFinite(n)?"–":Number.isInteger(n)?n.toLocaleString("en"):n.toLocaleString("en",{maximumSignificantDigits:e})}var ci=n=>n==null?"–":`${n.toFixed(2)} mm`,no=n=>`${(100*n).toFixed(n>.995||n<.1?1:0)} %`;function Si(n){if(n<1e3)return`${Math.round(n)} ms`;let e=n/1e3;return e<60?`${e.toFixed(1)} s`:e<3600?`${Math.floor(e/60)} min ${Math.round(e%60)} s`:e<86400?`${Math.floor(e/3600)} h ${Math.round(e%3600/60)} min`:`${Math.floor(e/86400)} d ${Math.round(e%86400/3600)} h`}var io=(n,e)=>{let t=e-Date.parse(n);return t<1e3?"now":Si(Math.floor(t/1e3)*1e3).replace(".0 s"," s")},Ol=n=>n<1024?`${n} B`:n<1<<20?`${(n/1024).toFixed(1)} KiB`:`${(n/(1<<20)).toFixed(1)} MiB`,Pn=n=>n.replaceAll("_"," "),Zn=n=>n!=="queued"&&n!=="running",Mi=n=>n.slice(-8),Bx={unlike_shape:{meaning:"Corresponding points differ in curvature or direction, or one surface is much longer than the other.",check:"Do both files show the same structure? Is a part of one missing?"},other_handedness:{meaning:"A mirrored source fits better.",check:"Is one file a left structure and the other a right one, or does an image have a flipped axis?"},uncertain_side:{meaning:"A file states two orientations of different handedness: left and right may be exchanged.",check:"Which orientation of the file is right? Write it into both places (sform and qform)."},units_differ:{meaning:"The sizes differ by the ratio of two units of length.",check:"Are both files in millimetres? Scale one of them, or state its unit in the file."},ambiguous_pose:{meaning:"A different pose fits as well.",check:"Is the shape nearly symmetric? Landmarks resolve it: submit again with a few corresponding points."},piece_dropped:{meaning:"A structure is in several pieces, and one that was dropped has 5 % or more of its volume.",check:"Are left and right one label, or several structures? Choose the labels of one, or name the repair largest_component."},labels_joined:{meaning:"Several labels of one input were joined, and the other input has other labels.",check:"Which labels are the structure? Submit again with them."},cavity_filled:{meaning:"A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much.",check:"Is the label a wall around something else? Name the repair fill to confirm that the inside belongs to it."},second_opinion:{meaning:"The default method finds another pose for these surfaces, or other corresponding points.",check:"Which of the two answers is right? Submit again with the method balanced, and look at both."},too_coarse:{meaning:"The voxels are so large for the structure that they leave its rotation uncertain.",check:"Is there a segmentation of smaller voxels? Interpolating this one adds nothing."}};function Xp(n){if(n.state==="succeeded"){if(n.reliable===!0)return{tone:"good",mark:"✓",title:"Reliable",lines:[`No check found a fault. ${n.surface_distance?`The registered surfaces are ${ci(n.surface_distance.mean_mm)} apart on average.`:""}`,...n.warnings??[]],next:"Look for colors that jump in the picture below; if there are none, keep this match."};if(n.reliable===!1){let i=(n.unreliable_reasons??[]).map(s=>Bx[s]??{meaning:Pn(s),check:""});return{tone:"bad",mark:"✕",title:"Not reliable",lines:[...i.map(s=>s.meaning),...n.warnings??[]],next:i.map(s=>s.check).join(" ")}}return{tone:"neutral",mark:"?",title:"Not checked",lines:["This method fits no displacement field, which the checks are made of.",...n.warnings??[]],next:"Judge by the picture, or match again with the method balanced."}}let t={queued:{tone:"wait",mark:"…",title:"Waiting",lines:[n.queue_position?`Number ${n.queue_position} in the queue.`:"In the queue."],next:"It starts when a worker is free."},running:{tone:"wait",mark:"…",title:n.cancel_requested?"Being cancelled":"Running",lines:[n.eta_ms?`About ${Si(n.eta_ms)} left.`:"The verdict comes with the result."],next:"The energy below shows how the match improves; each round begins anew."},cancelled:{tone:"neutral",mark:"–",title:"Cancelled",lines:["It has no result."],next:"Submit it again with Retry."},expired:{tone:"bad",mark:"✕",title:"Expired",lines:["It had not started by its deadline."],next:"Submit it again with Retry, or with a later deadline."}}[n.state];return t||{tone:"bad",mark:"✕",title:n.state==="dead"?"Given up":"Failed",lines:[[n.error?.title,n.error?.detail].filter(Boolean).join(": ")||"It has no result."],next:n.state==="dead"?"Its workers crashed too often. Retry once; if it fails again, report it.":"Correct the input, then submit it again."}}function Fl(n){if(n.state!=="succeeded")return{tone:"neutral",text:""};if(n.reliable===!0)return{tone:"good",text:"✓ reliable"};let[e,...t]=n.unreliable_reasons??[];return n.reliable===!1?{tone:"bad",text:`✕ ${Pn(e??"not reliable")}${t.length>0?` and ${t.length} more`:""}`}:{tone:"neutral",text:"not checked"}}function qp(n){return typeof n=="object"?n.key:n}function Yp(n,e){let t=n.length;return new Proxy(n,{get(i,s,r){if(typeof s=="string"){let o=s.charCodeAt(0);if(o>=48&&o<=57){let a=+s;if(Number.isInteger(a)&&a>=0&&a<t){let l=i[a];if(typeof l!="object"){let c=e[a*2];l=i[a]={index:a,key:l,start:c,size:e[a*2+1],end:c+e[a*2+1],lane:0}}return l}}if(s==="length")return t}return Reflect.get(i,s,r)}})}function xr(n,e,t){let i=t.initialDeps??[],s,r=!0;function o(){var a;let c=0,u=n();if(!(u.length!==i.length||u.some((d,_)=>i[_]!==d)))return s;i=u;let f=0;return s=e(...u),t?.onChange&&!(r&&t.skipInitialOnChange)&&t.onChange(s),r=!1,s}return o.updateDeps=a=>{i=a},o}function Fh(n,e){if(n===void 0)throw new Error(`Unexpected undefined${e?`: ${e}`:""}`);return n}var _s=(n,e)=>Math.abs(n-e)<1.01,$p=(n,e,t)=>{let i;return Object.assign(function(...s){n.clearTimeout(i),i=n.setTimeout(()=>e.apply(this,s),t)},{cancel:()=>{n.clearTimeout(i)}})};function Jp({offset:n,isScrolling:e,elementMax:t,holdOffset:i,scrollOffset:s,pendingWrite:r,clampedMaxAtWrite:o}){var a;return e&&r===null&&n===s?"spurious":r!==null&&Math.abs(n-r.target)<1.5?"readBack":r!==null&&!r.smooth&&t!==null&&r.target>t+i+.5&&Math.abs(n-(t+i))<1.5||r!==null&&!r.smooth&&((a=r.lowMaxes)!=null&&a.some(l=>Math.abs(n-l)<1.5))?"clampedReadBack":o!==null&&Math.abs(n-o)<1.5?"clampedEcho":"external"}var kx=n=>n==="smooth"||n==="smoothFinishing";function Zp({kind:n,offset:e,command:t,target:i}){return n!=="spurious"&&n!=="readBack"&&n!=="clampedReadBack"&&t?.index!=null&&t.phase!=="queued"&&!kx(t.phase)&&!_s(e,t.lastTargetOffset)&&!_s(e,i())&&n!=="clampedEcho"}var Uh=40;function Kp(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Uh;)t--;if(t<0)return!1;let i=n[t],s=t-1;for(;s>=0&&i.t-n[s].t<Uh;)s--;if(s<0)return!1;let r=n[s],o=(e.offset-i.offset)/(e.t-i.t),a=(i.offset-r.offset)/(i.t-r.t);return o*a>=0&&Math.abs(o)>=2*Math.abs(a)&&Math.abs(o)-Math.abs(a)>=.8}function jp(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Uh;)t--;if(t<0)return!1;let i=n[t];return Math.abs(e.offset-i.offset)/(e.t-i.t)>=.05}var fa,da=()=>{if(fa!==void 0)return fa;if(typeof navigator>"u")return fa=!1;if(/iP(hone|od|ad)/.test(navigator.userAgent))return fa=!0;let n=navigator.maxTouchPoints;return fa=navigator.platform==="MacIntel"&&n!==void 0&&n>0},Bh,zx=()=>Bh!==void 0?Bh:Bh=da()&&typeof CSS<"u"&&typeof CSS.supports=="function"&&CSS.supports("overflow-anchor: auto"),Qp=()=>!da()||zx();var so={capture:!0,passive:!0},Ul=class{constructor(e){this.host=e,this._touch=null,this.inMotion=()=>this._touch!==null&&this._touch.phase!=="lateFling",this.dragging=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved},this.tail=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="tail"?this._touch.moved?"fling":"tap":null},this.onScroll=({isScrolling:t,ownReadBack:i,moved:s,external:r})=>{var o,a,l;return t&&((o=this._touch)==null?void 0:o.phase)==="tail"?this._openTail(this._touch.moved||!i,!1):((a=this._touch)==null?void 0:a.phase)==="lateFling"&&(this.host.now()>this._touch.until?this._touch=null:r&&t&&s&&this._openTail(!0,!1)),!i&&t&&s&&((l=this._touch)==null?void 0:l.phase)==="down"?(this._touch.moved=!0,!0):!1},this.touchStart=()=>{this.end(),this._touch={phase:"down",moved:!1}},this.touchEnd=()=>{var t;let i=((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved;this.end(),this._openTail(i,i)},this.end=()=>{var t;let i=this.host.getWindow();((t=this._touch)==null?void 0:t.phase)==="tail"&&i!=null&&i.clearTimeout(this._touch.timerId),this._touch=null},this.listen=t=>{let i=()=>this.touchStart(),s=()=>this.touchEnd();return t.addEventListener("touchstart",i,so),t.addEventListener("touchend",s,so),t.addEventListener("touchcancel",s,so),()=>{t.removeEventListener("touchstart",i,so),t.removeEventListener("touchend",s,so),t.removeEventListener("touchcancel",s,so),this.end()}},this._openTail=(t,i)=>{let s=this.host.getWindow();if(s==null)return;this.end();let r={phase:"tail",moved:t,awaitingFling:i,timerId:s.setTimeout(()=>{if(this.host.tailStillMoving()){this._openTail(r.moved,r.awaitingFling);return}this._touch=r.awaitingFling?{phase:"lateFling",until:this.host.now()+1e3}:null,this.host.onTailClosed()},150)};this._touch=r}}get touch(){return this._touch}};var em=n=>{let{clientWidth:e,clientHeight:t}=n;return{width:e,height:t}},im=n=>{let e=new Set;return{schedule:t=>{let i=n.requestAnimationFrame(()=>{e.delete(i),t()});e.add(i)},cancel:()=>{e.forEach(t=>n.cancelAnimationFrame(t)),e.clear()}}},Vx=n=>n,Gx=n=>{let e=n.overscan*Math.max(n.lanes??1,1),t=Math.max(n.startIndex-e,0),s=Math.min(n.endIndex+e,n.count-1)-t+1,r=new Array(s);for(let o=0;o<s;o++)r[o]=t+o;return r},sm=(n,e)=>{let t=n.scrollElement;if(!t)return;let i=n.targetWindow;if(!i)return;let s=a=>{let{width:l,height:c}=a;e({width:Math.round(l),height:Math.round(c)})};if(s(em(t)),!i.ResizeObserver)return()=>{};let r=im(i),o=new i.ResizeObserver(()=>{let a=()=>{s(em(t))};n.options.useAnimationFrameWithResizeObserver?r.schedule(a):a()});return o.observe(t,{box:"content-box"}),()=>{o.unobserve(t),r.cancel()}},tm={passive:!0};var Hx=typeof window>"u"?!0:"onscrollend"in window,Wx=(n,e,t)=>{let i=n.scrollElement;if(!i)return;let s=n.targetWindow;if(!s)return;let r=n.options.useScrollendEvent&&Hx,o=0,a=r?null:$p(s,()=>e(t(i),!1),n.options.isScrollingResetDelay),l=h=>()=>{o=t(i),a?.(),e(o,h)},c=l(!0),u=l(!1);return i.addEventListener("scroll",c,tm),r&&i.addEventListener("scrollend",u,tm),()=>{i.removeEventListener("scroll",c),r&&i.removeEventListener("scrollend",u),a?.cancel()}},rm=(n,e)=>Wx(n,e,t=>{let{horizontal:i,isRtl:s}=n.options;return i?t.scrollLeft*(s&&-1||1):t.scrollTop});var Xx=(n,e,t)=>{if(t.options.useCachedMeasurements){let i=t.indexFromElement(n),s=t.options.getItemKey(i);return t.itemSizeCache.get(s)??t.options.estimateSize(i)}if(e?.borderBoxSize){let i=e.borderBoxSize[0];if(i)return Math.round(i[t.options.horizontal?"inlineSize":"blockSize"])}if(!e){let i=t.indexFromElement(n),s=t.options.getItemKey(i),r=t.itemSizeCache.get(s);if(r!==void 0)return r}return n[t.options.horizontal?"offsetWidth":"offsetHeight"]},qx=(n,{adjustments:e=0,behavior:t},i)=>{var s;let{scrollElement:r,options:o}=i,a=n+e,l=o.horizontal&&o.isRtl&&r!==null&&"ownerDocument"in r;(s=r?.scrollTo)==null||s.call(r,{[o.horizontal?"left":"top"]:l?-a:a,behavior:t})};var om=qx,nm=(n,e)=>n==="smooth"?e?"smoothLanded":"smooth":"instant",pa=n=>n?.phase==="smooth"||n?.phase==="smoothLanded";function Yx(n,e,t,i){if(e===0)return!1;let s=i(0),r=new Set,o=0;for(;o<n;){let l=t(o);if(l===s)break;r.add(l),o++}let a=n-o;if(a===0||a>=e)return!1;for(let l=0;l<a;l++)if(i(l)!==t(o+l))return!1;for(let l=a;l<e;l++)if(r.has(i(l)))return!1;return!0}var Bl=class{constructor(e){this.unsubs=[],this.scrollElement=null,this.targetWindow=null,this.isScrolling=!1,this.scrollState=null,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache=new Map,this.itemSizeCacheVersion=0,this.laneAssignments=new Map,this.pendingMin=null,this.prevLanes=void 0,this.lanesChangedFlag=!1,this.lanesSettling=!1,this.pendingScrollAnchor=null,this.scrollRect=null,this.scrollOffset=null,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._iosGesture=new Ul({getWindow:()=>this.targetWindow,now:()=>this.now(),tailStillMoving:()=>{let t=this.scrollState;if(t?.phase!=="queued"||this.pendingWrite!==null)return!1;let i=this._readElementOffset();return i===null||this._lastElementOffset===null||Math.abs(i-this._lastElementOffset)<1?!1:(this._lastElementOffset=i,t.samples=[...t.samples??[],{t:this.now(),offset:i}],!0)},onTailClosed:()=>{let t=this.scrollState;t?.phase==="queued"&&jp(t.samples??[])&&(this.scrollState=null),this._flushHoldIfReady(!0),this._writeAwaitingCommand(),this._retryClampedAdjustment()}}),this._lastElementOffset=null,this.pendingWrite=null,this._clampedAdjustment=null,this.elementsCache=new Map,this._resizeBatch=null,this.now=()=>{var t,i,s;return((s=(i=(t=this.targetWindow)==null?void 0:t.performance)==null?void 0:i.now)==null?void 0:s.call(i))??Date.now()},this.observer=(()=>{let t=null,i=null,s=!1,r=!1,o=new Set,a=()=>{if(t)return t;let c=this.targetWindow;if(!c||!c.ResizeObserver)return null;let u=i=im(c);return t=new c.ResizeObserver(h=>{let f=()=>{let d={sync:!1};this._resizeBatch=d;try{h.forEach(l)}finally{this._resizeBatch=null,d.notify&&(this.notify(d.sync),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment(),this.measureElement(null))}};if(this.options.useAnimationFrameWithResizeObserver)u.schedule(f);else{s=!0;try{f()}finally{s=!1}}})},l=c=>{let u=c.target,h=this.indexFromElement(u);if(!u.isConnected){this.observer.unobserve(u);for(let[f,d]of this.elementsCache)if(d===u){this.elementsCache.delete(f);break}return}this.isIndexInRange(h)&&this.shouldMeasureDuringScroll(h)&&this.resizeItem(h,this.options.measureElement(u,c,this))};return{disconnect:()=>{var c;(c=a())==null||c.disconnect(),i?.cancel(),o.clear(),r=!1,t=null,i=null},observe:c=>{let u=a();if(u){if(!s){u.observe(c,{box:"border-box"});return}o.add(c),r||(r=!0,i?.schedule(()=>{r=!1,o.forEach(h=>{h.isConnected&&t?.observe(h,{box:"border-box"})}),o.clear()}))}},unobserve:c=>{var u;o.delete(c),(u=a())==null||u.unobserve(c)}}})(),this.range=null,this.setOptions=t=>{var i;let s={debug:!1,initialOffset:0,overscan:1,paddingStart:0,paddingEnd:0,scrollPaddingStart:0,scrollPaddingEnd:0,horizontal:!1,getItemKey:Vx,rangeExtractor:Gx,onChange:()=>{},measureElement:Xx,initialRect:{width:0,height:0},scrollMargin:0,gap:0,indexAttribute:"data-index",initialMeasurementsCache:[],lanes:1,anchorTo:"start",followOnAppend:!1,scrollEndThreshold:1,isScrollingResetDelay:150,enabled:!0,isRtl:!1,useScrollendEvent:!1,useAnimationFrameWithResizeObserver:!1,laneAssignmentMode:"estimate",useCachedMeasurements:!1};for(let u in t){let h=t[u];h!==void 0&&(s[u]=h)}let r=this.options,o=null,a=null,l=!1;if(r!==void 0&&r.enabled&&s.enabled&&s.anchorTo==="end"&&this.scrollElement!==null){let u=r.count,h=s.count,f=this.getMeasurements(),d=((i=this._singleLaneMeasurements)==null?void 0:i.items)??f,_=M=>qp(d[M]),v=u>0?_(0):null,p=u>0?_(u-1):null;if(h!==u||u>0&&h>0&&(s.getItemKey(0)!==v||s.getItemKey(h-1)!==p)){l=!0;let M=u>0?this.getVirtualItemForOffset(this.getScrollOffset())??f[0]:null;M&&(o=[M.key,this.getScrollOffset()-M.start]);let b=s.followOnAppend===!0?"auto":s.followOnAppend||null;b&&h>0&&this.isAtEnd(r.scrollEndThreshold)&&(u===0||s.getItemKey(h-1)!==p)&&(h>u||Yx(u,h,_,s.getItemKey))&&(a=b)}}this.options=s,l&&(this.pendingMin=0,this.itemSizeCacheVersion++);let c=null;if(o&&this.scrollOffset!==null&&!this._awaitingCommandReadBack()){let[u,h]=o,f=this.getMeasurements(),{count:d,getItemKey:_}=this.options,v=0;for(;v<d&&_(v)!==u;)v++;if(v<d){let p=f[v];if(p){let g=Math.max(0,p.start+h);!a&&g!==this.scrollOffset&&(c=g-this.scrollOffset,this.scrollOffset=g)}}}a?this.pendingScrollAnchor={kind:"follow",behavior:a}:c!==null&&(this._canWriteScroll()?this.pendingScrollAnchor={kind:"anchor",delta:c}:(this._holdOffset+=c,this._followOffsetTarget(c)))},this.notify=t=>{var i,s;(s=(i=this.options).onChange)==null||s.call(i,this,t)},this.maybeNotify=xr(()=>(this.calculateRange(),[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]),t=>{this.notify(t)},{key:!1,debug:()=>this.options.debug,initialDeps:[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]}),this.cleanup=()=>{var t;this.unsubs.filter(Boolean).forEach(i=>i()),this.unsubs=[],this.observer.disconnect(),this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null,(t=this._momentumStop)==null||t.restore(),this._momentumStop=null,this.isScrolling=!1,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._clampedAdjustment=null,this.pendingWrite=null,this.scrollElement=null,this.targetWindow=null},this._didMount=()=>()=>{this.cleanup()},this._willUpdate=()=>{var t;let i=this.options.enabled?this.options.getScrollElement():null;if(this.scrollElement!==i){if(this.cleanup(),!i){this.maybeNotify();return}this.scrollElement=i,this.scrollElement&&"ownerDocument"in this.scrollElement?this.targetWindow=this.scrollElement.ownerDocument.defaultView:this.targetWindow=((t=this.scrollElement)==null?void 0:t.window)??null,this.elementsCache.forEach(r=>{this.observer.observe(r)}),this.unsubs.push(this.options.observeElementRect(this,r=>{this.scrollRect=r,this.maybeNotify()})),this.unsubs.push(this.options.observeElementOffset(this,(r,o)=>{var a,l,c,u;let h=o?this._elementMaxScrollOffset():null,f=this._reportedOverscroll;this._reportedOverscroll=r<0||h!==null&&r>h+1;let d=r;this._lastElementOffset=d,r=this._toLayoutOffset(r);let _=this._classifyScrollEvent(r,o,h);if(_==="spurious")return;_==="readBack"?r=this.pendingWrite.target:_==="clampedReadBack"&&((a=this.scrollState)==null?void 0:a.index)!=null&&r<this.getMaxScrollOffset()-1.5?this.scrollState.lastTargetOffset=r:Zp({kind:_,offset:r,command:this.scrollState,target:()=>this.getScrollStateTarget(this.scrollState)})&&(this.scrollState=null),this.pendingWrite=null,this._clampedAdjustment!==null&&Math.abs(r-this._clampedAdjustment.maxAtWrite)>=1.5&&(this._clampedAdjustment=null);let v=this.getScrollOffset(),p=this.scrollDirection;this.scrollDirection=o?v===r?this.scrollDirection:v<r?"forward":"backward":null,this.scrollOffset=r,this.isScrolling=o;let g=this.scrollState;if(g?.phase==="queued"&&_==="external"&&o)if(f||this._reportedOverscroll)g.samples=[];else{let x=this.now();g.samples=[...(g.samples??[]).filter(M=>x-M.t<=200),{t:x,offset:d}],(p!==null&&this.scrollDirection!==p||Kp(g.samples))&&(this.scrollState=null)}this._iosGesture.onScroll({isScrolling:o,ownReadBack:_==="readBack",moved:r!==v,external:_==="external"&&((l=this.scrollState)==null?void 0:l.phase)!=="smooth"&&((c=this.scrollState)==null?void 0:c.phase)!=="smoothFinishing"})&&((u=this.scrollState)==null?void 0:u.phase)==="queued"&&(this.scrollState=null),this._flushHoldIfReady(!0),this.scrollState&&this.scheduleScrollReconcile(),this.maybeNotify()})),"addEventListener"in this.scrollElement&&this.unsubs.push(this._iosGesture.listen(this.scrollElement)),this._scrollToOffset(this.getScrollOffset())}this._noteClampMax();let s=this.pendingScrollAnchor;this.pendingScrollAnchor=null,s&&this.scrollElement&&this.options.enabled&&(s.kind==="anchor"?this._canWriteScroll()?pa(this.scrollState)&&!_s(this.getScrollOffset()-s.delta,this.scrollState.lastTargetOffset)||(this._followOffsetTarget(s.delta),this._scrollToOffset(this.getScrollOffset())):(this._holdOffset+=s.delta,this._followOffsetTarget(s.delta),this.notify(!1)):this.scrollToEnd({behavior:s.behavior})),this._flushHoldIfReady(!1),this._retryClampedAdjustment()},this._classifyScrollEvent=(t,i,s)=>{var r;return Jp({offset:t,isScrolling:i,elementMax:s,holdOffset:this._holdOffset,scrollOffset:this.scrollOffset,pendingWrite:this.pendingWrite,clampedMaxAtWrite:((r=this._clampedAdjustment)==null?void 0:r.maxAtWrite)??null})},this._retryClampedAdjustment=()=>{if(this._clampedAdjustment===null||!this.scrollElement||!this.options.enabled||!this._canWriteScroll())return;let{target:t,maxAtWrite:i}=this._clampedAdjustment,s=this.getMaxScrollOffset();s>i+.5&&(this._clampedAdjustment=t>s+.5?{target:t,maxAtWrite:s}:null,this._scrollToOffset(t))},this._writeAwaitingCommand=()=>{let t=this.scrollState;if(t===null||t.phase!=="queued")return;let{behavior:i}=t;this.getMeasurements();let s=this.getScrollStateTarget(t);t.lastTargetOffset=s,this._clampedAdjustment=null,t.phase=nm(i,t.index!=null&&_s(s,this.getScrollOffset())),this._scrollToOffset(s,{behavior:i}),this.scheduleScrollReconcile()},this._readElementOffset=()=>{let t=this.scrollElement;if(t==null)return null;let{horizontal:i,isRtl:s}=this.options;return typeof t.scrollTop=="number"?i?t.scrollLeft*(s&&-1||1):t.scrollTop:typeof t.scrollY=="number"?i?t.scrollX:t.scrollY:null},this._canWriteScroll=()=>!(da()&&this._iosGesture.inMotion())&&!this._reportedOverscroll,this._flushHoldIfReady=t=>{var i;if(this._holdOffset===0||!this.scrollElement||!this.options.enabled||!this._canWriteScroll()||((i=this.scrollState)==null?void 0:i.phase)==="smooth")return;this._holdOffset=0,this.scrollOffset!==null&&this.scrollOffset<0&&(this.scrollOffset=0),this.notify(t);let s=this.getCommandWrittenOffset()??this.getScrollOffset();this._clampedAdjustment=this._clampedBy(s),this._scrollToOffset(s)},this.rafId=null,this.getSize=()=>this.options.enabled?(this.scrollRect=this.scrollRect??this.options.initialRect,this.scrollRect[this.options.horizontal?"width":"height"]):(this.scrollRect=null,0),this.getScrollOffset=()=>this.options.enabled?(this.scrollOffset=this.scrollOffset??(typeof this.options.initialOffset=="function"?this.options.initialOffset():this.options.initialOffset),this.scrollOffset):(this.scrollOffset=null,0),this.getMeasurementOptions=xr(()=>[this.options.count,this.options.paddingStart,this.options.scrollMargin,this.options.getItemKey,this.options.enabled,this.options.lanes,this.options.laneAssignmentMode,this.options.gap],(t,i,s,r,o,a,l,c)=>(this.prevLanes!==void 0&&this.prevLanes!==a&&(this.lanesChangedFlag=!0),this.prevLanes=a,this.pendingMin=null,{count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c}),{key:!1}),this.isIndexInRange=t=>t>=0&&t<this.options.count,this.getMeasurements=xr(()=>[this.getMeasurementOptions(),this.itemSizeCacheVersion],({count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c},u)=>{var h;let f=this.itemSizeCache;if(!o)return this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),[];if(this.laneAssignments.size>t)for(let x of this.laneAssignments.keys())x>=t&&this.laneAssignments.delete(x);this.lanesChangedFlag&&(this.lanesChangedFlag=!1,this.lanesSettling=!0,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.pendingMin=null),this.measurementsCache.length===0&&!this.lanesSettling&&(this.measurementsCache=this.options.initialMeasurementsCache,this.measurementsCache.forEach(x=>{this.itemSizeCache.set(x.key,x.size)}));let d=this.lanesSettling?0:this.pendingMin??0;if(this.pendingMin=null,this.lanesSettling&&this.measurementsCache.length===t&&(this.lanesSettling=!1),a===1){let x=t*2,M=(h=this._singleLaneMeasurements)==null?void 0:h.flat;if(!M||M.length<x){let m=new Float64Array(x);M&&d>0&&m.set(M.subarray(0,d*2)),M=m}let b=d===0?new Array(t):this._singleLaneMeasurements.items.slice(),y;if(d===0)y=i+s;else{let m=d-1;y=M[m*2]+M[m*2+1]+c}for(let m=d;m<t;m++){let w=r(m);b[m]=w;let I=f.get(w),P=typeof I=="number"?I:this.options.estimateSize(m);M[m*2]=y,M[m*2+1]=P,y+=P+c}this._singleLaneMeasurements={flat:M,items:b};let S=Yp(b,M);return this.measurementsCache=S,S}let _=this.measurementsCache.slice(0,d),v=new Array(a).fill(void 0),p=new Float64Array(a),g=0;for(let x=0;x<d;x++){let M=_[x];M&&(v[M.lane]===void 0&&g++,v[M.lane]=x,p[M.lane]=M.end)}for(let x=d;x<t;x++){let M=r(x),b=this.laneAssignments.get(x),y,S,m=l==="estimate"||f.has(M);if(b!==void 0&&this.options.lanes>1){y=b;let L=v[y],N=L!==void 0?_[L]:void 0;S=N?N.end+c:i+s}else if(g===a){let L=0,N=p[0],B=v[0];for(let D=1;D<a;D++){let G=p[D];(G<N||G===N&&v[D]<B)&&(L=D,N=G,B=v[D])}y=L,S=N+c,m&&this.laneAssignments.set(x,y)}else y=x%this.options.lanes,S=i+s,m&&this.laneAssignments.set(x,y);let w=f.get(M),I=typeof w=="number"?w:this.options.estimateSize(x),P=S+I;_[x]={index:x,start:S,size:I,end:P,key:M,lane:y},v[y]===void 0&&g++,v[y]=x,p[y]=P}return this.measurementsCache=_,_},{key:!1,debug:()=>this.options.debug}),this.calculateRange=xr(()=>[this.getMeasurements(),this.getSize(),this.getScrollOffset(),this.options.lanes,this._getLayoutTotalSize()+this.options.scrollMargin],(t,i,s,r,o)=>{if(t.length===0||i===0)return this.range=null,null;let a=Math.max(o-i,0);return this.range=Jx(t,i,Math.min(s,a),r,r===1&&this._singleLaneMeasurements!==null?this._singleLaneMeasurements.flat:null),this.range},{key:!1,debug:()=>this.options.debug}),this.getVirtualIndexes=xr(()=>{let t=null,i=null,s=this.calculateRange();return s&&(t=s.startIndex,i=s.endIndex),this.maybeNotify.updateDeps([this.isScrolling,t,i]),[this.options.rangeExtractor,this.options.overscan,this.options.count,t,i,this.options.lanes]},(t,i,s,r,o,a)=>r===null||o===null?[]:t({startIndex:r,endIndex:o,overscan:i,count:s,lanes:a}),{key:!1,debug:()=>this.options.debug}),this.indexFromElement=t=>{let i=this.options.indexAttribute,s=t.getAttribute(i);return s?parseInt(s,10):(console.warn(`Missing attribute name '${i}={index}' on measured element.`),-1)},this.shouldMeasureDuringScroll=t=>{var i;if(!pa(this.scrollState))return!0;let s=this.scrollState.index??((i=this.getVirtualItemForOffset(this.scrollState.lastTargetOffset))==null?void 0:i.index);if(s!==void 0&&this.range){let r=Math.max(this.options.overscan,Math.ceil((this.range.endIndex-this.range.startIndex)/2)),o=Math.max(0,s-r),a=Math.min(this.options.count-1,s+r);return t>=o&&t<=a}return!0},this.measureElement=t=>{if(!t){this.elementsCache.forEach((o,a)=>{o.isConnected||(this.observer.unobserve(o),this.elementsCache.delete(a))});return}let i=this.indexFromElement(t);if(!this.isIndexInRange(i))return;let s=this.options.getItemKey(i),r=this.elementsCache.get(s);r!==t&&(r&&this.observer.unobserve(r),this.observer.observe(t),this.elementsCache.set(s,t)),t.isConnected&&(!this.isScrolling||this.scrollState)&&this.shouldMeasureDuringScroll(i)&&this.resizeItem(i,this.options.measureElement(t,void 0,this))},this.resizeItem=(t,i)=>{var s,r,o;if(!this.isIndexInRange(t))return;(s=this._resizeBatch)!=null&&s.sync&&this.getMeasurements();let a,l,c,u=(r=this._singleLaneMeasurements)==null?void 0:r.flat;if(this.options.lanes===1&&u!=null)c=this.options.getItemKey(t),l=u[t*2],a=u[t*2+1];else{let d=this.measurementsCache[t];if(!d)return;c=d.key,l=d.start,a=d.size}let h=this.itemSizeCache.get(c)??a,f=i-h;if(f!==0){let d=this.options.anchorTo==="end"&&!pa(this.scrollState)&&this.getVirtualDistanceFromEnd()<=this.options.scrollEndThreshold,_=d?this._getLayoutTotalSize():0,v=this.getScrollOffset(),g=!this.itemSizeCache.has(c)?l<v:l+h<=v&&this.scrollDirection!=="backward",x=!pa(this.scrollState)&&(this.shouldAdjustScrollPositionOnItemSizeChange!==void 0?this.shouldAdjustScrollPositionOnItemSizeChange(this.measurementsCache[t]??{index:t,key:c,start:l,size:a,end:l+a,lane:0},f,this):g);(this.pendingMin===null||t<this.pendingMin)&&(this.pendingMin=t),this.itemSizeCache.set(c,i),this.itemSizeCacheVersion++;let M=!1;if(this._awaitingCommandReadBack()||(d?M=this.applyScrollAdjustment(this._getLayoutTotalSize()-_):x&&(M=this.applyScrollAdjustment(f))),this._resizeBatch){this._resizeBatch.notify=!0,(o=this._resizeBatch).sync||(o.sync=M);return}this.notify(M),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment()}},this.getVirtualItems=xr(()=>[this.getVirtualIndexes(),this.getMeasurements(),this._holdOffset],(t,i,s)=>{let r=[];for(let o=0,a=t.length;o<a;o++){let l=t[o],c=i[l];r.push(s===0?c:{...c,start:c.start-s,end:c.end-s})}return r},{key:!1,debug:()=>this.options.debug}),this.getVirtualItemForOffset=t=>{var i;let s=this.getMeasurements();if(s.length===0)return;let r=(i=this._singleLaneMeasurements)==null?void 0:i.flat,o=this.options.lanes===1&&r!=null,a=am(0,s.length-1,o?l=>r[l*2]:l=>Fh(s[l]).start,t);return Fh(s[a])},this._noteClampMax=()=>{if(!this._awaitingCommandReadBack())return;let t=this._elementMaxScrollOffset();if(t===null)return;let i=this.pendingWrite,s=Math.max(t,0)+this._holdOffset;if(s>=i.target)return;let r=i.lowMaxes??(i.lowMaxes=[]);r[r.length-1]!==s&&r.push(s)},this.getMaxScrollOffset=()=>(this._elementMaxScrollOffset()??0)+this._holdOffset,this._toLayoutOffset=t=>{var i;let s=t+this._holdOffset;return((i=this.pendingScrollAnchor)==null?void 0:i.kind)==="anchor"&&(s+=this.pendingScrollAnchor.delta),s},this._elementMaxScrollOffset=()=>{let t=this.scrollElement;if(t===null)return null;if("scrollHeight"in t)return this.options.horizontal?t.scrollWidth-t.clientWidth:t.scrollHeight-t.clientHeight;if("document"in t){let i=t.document.documentElement;return this.options.horizontal?i.scrollWidth-t.innerWidth:i.scrollHeight-t.innerHeight}return null},this._momentumStop=null,this._stopMomentum=t=>{let i=this.scrollElement,s=this.targetWindow;if(i===null||s===null)return;let r="document"in i?i.document.scrollingElement:i;if(!r?.style)return;if(this._momentumStop){this._momentumStop.done=t;return}let{style:o}=r,a=this.options.horizontal?"overflow-x":"overflow-y",l=o.getPropertyValue(a),c=o.getPropertyPriority(a),u=()=>this.options.horizontal?r.clientHeight:r.clientWidth,h=u();if(o.setProperty(a,"hidden","important"),u()!==h){o.setProperty(a,l,c);return}let f={restore:()=>o.getPropertyValue(a)!=="hidden"||o.getPropertyPriority(a)!=="important"?!1:(o.setProperty(a,l,c),!0),done:t};this._momentumStop=f,s.requestAnimationFrame(()=>s.requestAnimationFrame(()=>{this._momentumStop===f&&(this._momentumStop=null,f.restore()&&f.done())}))},this._clampedBy=t=>{let i=this._elementMaxScrollOffset();if(i===null)return null;let s=i+this._holdOffset;return t>s+.5?{target:t,maxAtWrite:s}:null},this.getVirtualDistanceFromEnd=()=>Math.max(this._getLayoutTotalSize()+this.options.scrollMargin-this.getSize()-this.getScrollOffset(),0),this.getDistanceFromEnd=()=>Math.max(this.getMaxScrollOffset()-this.getScrollOffset(),0),this.isAtEnd=(t=this.options.scrollEndThreshold)=>this.getDistanceFromEnd()<=t,this.getOffsetForAlignment=(t,i,s=0)=>{if(!this.scrollElement)return 0;let r=this.getSize(),o=this.getScrollOffset();i==="auto"&&(i=t>=o+r?"end":"start"),i==="center"?t+=(s-r)/2:i==="end"&&(t-=r);let a=this.getMaxScrollOffset();return Math.max(Math.min(a,t),0)},this.getOffsetForIndex=(t,i="auto")=>{t=Math.max(0,Math.min(t,this.options.count-1));let s=this.getSize(),r=this.getScrollOffset(),o=this.getMeasurements()[t];if(!o)return;if(i==="auto")if(o.end>=r+s-this.options.scrollPaddingEnd)i="end";else if(o.start<=r+this.options.scrollPaddingStart)i="start";else return[r,i];if(i==="end"&&t===this.options.count-1){let l=this.getMaxScrollOffset(),c=l-this.options.paddingEnd+this.options.scrollPaddingEnd;return[Math.max(Math.min(c,l),0),i]}let a=i==="end"?o.end+this.options.scrollPaddingEnd:o.start-this.options.scrollPaddingStart;return[this.getOffsetForAlignment(a,i,o.size),i]},this.scrollToOffset=(t,{align:i="start",behavior:s="auto"}={})=>{this._startScroll({index:null,align:i},this.getOffsetForAlignment(t,i),s,"absolute")},this.scrollToIndex=(t,{align:i="auto",behavior:s="auto"}={})=>{t=Math.max(0,Math.min(t,this.options.count-1));let r=this.getOffsetForIndex(t,i);if(!r)return;let[o,a]=r;this._startScroll({index:t,align:a},o,s,"absolute")},this.scrollBy=(t,{behavior:i="auto"}={})=>{let s=this.getOffsetForAlignment((this.getCommandWrittenOffset()??this.getScrollOffset())+t,"start");this._startScroll({index:null,align:"start"},s,i,"relative")},this.scrollToEnd=({behavior:t="auto"}={})=>{if(this.options.count>0){this._startScroll({index:this.options.count-1,align:"end",toEnd:!0},Math.max(this.getMaxScrollOffset(),0),t,"absolute");return}this.scrollToOffset(Math.max(this.getTotalSize()-this.getSize(),0),{behavior:t})},this.cancelScroll=()=>{this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null},this.getTotalSize=()=>Math.max(this._getLayoutTotalSize()-this._holdOffset,0),this._getLayoutTotalSize=()=>{var t,i;let s=this.getMeasurements(),r;if(s.length===0)r=this.options.paddingStart;else if(this.options.lanes===1){let o=s.length-1,a=(t=this._singleLaneMeasurements)==null?void 0:t.flat;a!=null?r=a[o*2]+a[o*2+1]:r=((i=s[o])==null?void 0:i.end)??0}else{let o=Array(this.options.lanes).fill(null),a=s.length-1;for(;a>=0&&o.some(l=>l===null);){let l=s[a];o[l.lane]===null&&(o[l.lane]=l.end),a--}r=Math.max(...o.filter(l=>l!==null))}return Math.max(r-this.options.scrollMargin+this.options.paddingEnd,0)},this.takeSnapshot=()=>{let t=[];if(this.itemSizeCache.size===0)return t;let i=this.getMeasurements();for(let s of i)s&&this.itemSizeCache.has(s.key)&&t.push({index:s.index,key:s.key,start:s.start,size:s.size,end:s.end,lane:s.lane});return t},this._scrollToOffset=(t,{adjustments:i,behavior:s}={})=>{let r={target:t+(i??0),smooth:s==="smooth"};return this.pendingWrite=r,this.options.scrollToFn(t-this._holdOffset,{behavior:s,adjustments:i},this),r},this.getCommandWrittenOffset=()=>this.scrollState!==null&&this.pendingWrite!==null&&!this.pendingWrite.smooth?this.pendingWrite.target:null,this._awaitingCommandReadBack=()=>{let t=this.getCommandWrittenOffset();return!(da()&&this._iosGesture.dragging())&&t!==null&&!_s(t,this.getScrollOffset())},this._followOffsetTarget=t=>{this.scrollState!==null&&this.scrollState.index==null&&(this.scrollState.lastTargetOffset+=t)},this.measure=()=>{this.pendingMin=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.itemSizeCacheVersion++,this.notify(!1)},this.setOptions(e)}get scrollAdjustments(){return 0}applyScrollAdjustment(e,t){if(e===0)return!1;if(this._followOffsetTarget(e),this._canWriteScroll()){let i=this.getScrollOffset();this._clampedAdjustment=this._clampedBy(i+e);let s=this._scrollToOffset(i,{adjustments:e,behavior:t});return this.scrollOffset!==null&&(this.pendingWrite===s&&(this.scrollOffset+=e),this.scrollOffset<0&&(this.scrollOffset=0)),!0}else return this._holdOffset+=e,this.scrollOffset!==null&&(this.scrollOffset+=e),!0}scheduleScrollReconcile(){if(!this.targetWindow){this.scrollState=null;return}this.rafId==null&&(this.rafId=this.targetWindow.requestAnimationFrame(()=>{this.rafId=null,this.reconcileScroll()}))}getScrollStateTarget(e){let t=e.toEnd?[Math.max(this.getMaxScrollOffset(),0)]:e.index!=null?this.getOffsetForIndex(e.index,e.align):void 0;return t?t[0]:e.lastTargetOffset}reconcileScroll(){if(!this.scrollState||!this.scrollElement)return;if(this.now()-this.scrollState.startedAt>5e3){this.scrollState=null;return}if(this.scrollState.phase==="queued"){this.scheduleScrollReconcile();return}this.getMeasurements();let i=this.getScrollStateTarget(this.scrollState),s=this.scrollState.index==null?1:this.options.useAnimationFrameWithResizeObserver?3:2,r=i!==this.scrollState.lastTargetOffset;if(!r&&_s(i,this.getScrollOffset())){if(this.scrollState.phase==="smooth"?this.scrollState.phase="smoothLanded":this.scrollState.phase==="smoothFinishing"&&(this.scrollState.phase="instant"),this.scrollState.stableFrames++,this.scrollState.stableFrames>=s){this.getScrollOffset()!==i&&this._scrollToOffset(i,{behavior:"auto"}),this.scrollState=null;return}}else if(this.scrollState.stableFrames=0,r){let o=this.getSize()||600,a=Math.abs(i-this.getScrollOffset()),l=pa(this.scrollState)&&a>o;this.scrollState.lastTargetOffset=i,l?this.scrollState.phase="smooth":this.scrollState.phase==="smooth"?this.scrollState.phase="smoothFinishing":this.scrollState.phase==="smoothLanded"&&(this.scrollState.phase="instant"),this._scrollToOffset(i,{behavior:l?"smooth":"auto"})}this.scheduleScrollReconcile()}_startScroll(e,t,i,s){this.pendingScrollAnchor=null,this._clampedAdjustment=null;let r=this._iosGesture.tail();if(s==="absolute"&&r!==null){if(r==="fling"&&Qp()){this._stopMomentum(()=>{let o=this.scrollState;o?.phase!=="queued"||this._iosGesture.tail()!=="fling"||this._reportedOverscroll||(this._iosGesture.end(),this._flushHoldIfReady(!0),this._writeAwaitingCommand())}),this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,phase:"queued",behavior:i,samples:[]},this.scheduleScrollReconcile();return}this._iosGesture.end()}this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,behavior:i,phase:nm(i,e.index!=null&&_s(t,this.getScrollOffset()))},this._scrollToOffset(t,{behavior:i}),this.scheduleScrollReconcile()}},am=(n,e,t,i)=>{for(;n<=e;){let s=(n+e)/2|0,r=t(s);if(r<i)n=s+1;else if(r>i)e=s-1;else return s}return n>0?n-1:0};function $x(n,e,t){let i=0;for(;i<=e;){let s=(i+e)/2|0,r=n[s*2];if(r<t)i=s+1;else if(r>t)e=s-1;else return s}return i>0?i-1:0}function Jx(n,e,t,i,s){let r=n.length-1;if(n.length<=i)return{startIndex:0,endIndex:r};if(i===1&&s!==null){let c=$x(s,r,t),u=c,h=t+e;for(;u<r&&s[u*2]+s[u*2+1]<h;)u++;return{startIndex:c,endIndex:u}}let a=am(0,r,c=>n[c].start,t),l=a;if(i===1)for(;l<r&&n[l].end<t+e;)l++;else if(i>1){let c=Array(i).fill(0);for(;l<r&&c.some(h=>h<t+e);){let h=n[l];c[h.lane]=h.end,l++}let u=Array(i).fill(t+e);for(;a>=0&&u.some(h=>h>=t);){let h=n[a];u[h.lane]=h.start,a--}a=Math.max(0,a-a%i),l=Math.min(r,l+(i-1-l%i))}return{startIndex:a,endIndex:l}}var ma=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},lm=10,Zx=13,vr=32;function kh(n){}function hm(n){if(typeof n=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=kh,onError:t=kh,onRetry:i=kh,onComment:s,maxBufferSize:r}=n,o=[],a=0,l=!0,c,u="",h=0,f,d=!1;function _(y){if(d)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,y.charCodeAt(0)===239&&y.charCodeAt(1)===187&&y.charCodeAt(2)===191&&(y=y.slice(3))),o.length===0){let w=p(y);w!==""&&(o.push(w),a=w.length),v();return}if(y.indexOf(`
`)===-1&&y.indexOf("\r")===-1){o.push(y),a+=y.length,v();return}o.push(y);let S=o.join("");o.length=0,a=0;let m=p(S);m!==""&&(o.push(m),a=m.length),v()}function v(){r!==void 0&&(a+u.length<=r||(d=!0,o.length=0,a=0,c=void 0,u="",h=0,f=void 0,t(new ma(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function p(y){let S=0;if(y.indexOf("\r")===-1){let m=y.indexOf(`
`,S);for(;m!==-1;){if(S===m){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0,S=m+1,m=y.indexOf(`
`,S);continue}let w=y.charCodeAt(S);if(cm(y,S,w)){let I=y.charCodeAt(S+5)===vr?S+6:S+5,P=y.slice(I,m);if(h===0&&y.charCodeAt(m+1)===lm){e({id:c,event:f,data:P}),c=void 0,u="",f=void 0,S=m+2,m=y.indexOf(`
`,S);continue}u=h===0?P:`${u}
${P}`,h++}else um(y,S,w)?f=y.slice(y.charCodeAt(S+6)===vr?S+7:S+6,m)||void 0:g(y,S,m);S=m+1,m=y.indexOf(`
`,S)}return y.slice(S)}for(;S<y.length;){let m=y.indexOf("\r",S),w=y.indexOf(`
`,S),I=-1;if(m!==-1&&w!==-1?I=m<w?m:w:m!==-1?m===y.length-1?I=-1:I=m:w!==-1&&(I=w),I===-1)break;g(y,S,I),S=I+1,y.charCodeAt(S-1)===Zx&&y.charCodeAt(S)===lm&&S++}return y.slice(S)}function g(y,S,m){if(S===m){M();return}let w=y.charCodeAt(S);if(cm(y,S,w)){let D=y.charCodeAt(S+5)===vr?S+6:S+5,G=y.slice(D,m);u=h===0?G:`${u}
${G}`,h++;return}if(um(y,S,w)){f=y.slice(y.charCodeAt(S+6)===vr?S+7:S+6,m)||void 0;return}if(w===105&&y.charCodeAt(S+1)===100&&y.charCodeAt(S+2)===58){let D=y.slice(y.charCodeAt(S+3)===vr?S+4:S+3,m);D.includes("\0")||(c=D);return}if(w===58){if(s){let D=y.slice(S,m);s(D.slice(y.charCodeAt(S+1)===vr?2:1))}return}let I=y.slice(S,m),P=I.indexOf(":");if(P===-1){x(I,"",I);return}let L=I.slice(0,P),N=I.charCodeAt(P+1)===vr?2:1,B=I.slice(P+N);x(L,B,I)}function x(y,S,m){switch(y){case"event":f=S||void 0;break;case"data":u=h===0?S:`${u}
${S}`,h++;break;case"id":S.includes("\0")||(c=S);break;case"retry":/^\d+$/.test(S)?i(parseInt(S,10)):t(new ma(`Invalid \`retry\` value: "${S}"`,{type:"invalid-retry",value:S,line:m}));break;default:t(new ma(`Unknown field "${y.length>20?`${y.slice(0,20)}…`:y}"`,{type:"unknown-field",field:y,value:S,line:m}));break}}function M(){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0}function b(y={}){if(y.consume&&o.length>0){let S=o.join("");g(S,0,S.length)}l=!0,c=void 0,u="",h=0,f=void 0,o.length=0,a=0,d=!1}return{feed:_,reset:b}}function cm(n,e,t){return t===100&&n.charCodeAt(e+1)===97&&n.charCodeAt(e+2)===116&&n.charCodeAt(e+3)===97&&n.charCodeAt(e+4)===58}function um(n,e,t){return t===101&&n.charCodeAt(e+1)===118&&n.charCodeAt(e+2)===101&&n.charCodeAt(e+3)===110&&n.charCodeAt(e+4)===116&&n.charCodeAt(e+5)===58}var kl=class extends TransformStream{constructor({onError:e,onRetry:t,onComment:i,maxBufferSize:s}={}){let r;super({start(o){r=hm({onEvent:a=>{o.enqueue(a)},onError(a){typeof e=="function"&&e(a),(e==="terminate"||a.type==="max-buffer-size-exceeded")&&o.error(a)},onRetry:t,onComment:i,maxBufferSize:s})},transform(o){r.feed(o)}})}};function yr(n,e){return!n||n.id!==e.id?e:Zn(n.state)&&!Zn(e.state)?n:n.cancel_requested&&!e.cancel_requested?{...e,cancel_requested:!0}:e}var wi=(n,e)=>new Promise(t=>{let i=()=>{clearTimeout(s),e.removeEventListener("abort",i),t()},s=setTimeout(i,n);e.addEventListener("abort",i)}),ro=n=>n instanceof Oi&&n.problem.status<500&&n.problem.status!==429;async function br(n,e){for(let t=500;;t=Math.min(t*2,8e3)){try{return await n()}catch(i){if(e.aborted||ro(i))throw i}await wi(t,e),e.throwIfAborted()}}var Kx=4e4,jx=30;async function fm(n,e,t){let i,s=0,r=500;for(;!t.aborted;){let o=new AbortController,a=()=>o.abort();t.addEventListener("abort",a,{once:!0});let l=0;try{let c={accept:"text/event-stream"};i!==void 0&&(c["last-event-id"]=i);let u=await bi(`v1/jobs/${n}/events`,{headers:c,signal:o.signal,cache:"no-store"});if(u.status===204||u.body===null)return;e.connected(!0),r=500;let h=()=>{clearTimeout(l),l=window.setTimeout(a,Kx)},f=new TransformStream({transform(g,x){h(),x.enqueue(g)}}),d=new TextDecoderStream,v=u.body.pipeThrough(f).pipeThrough(d).pipeThrough(new kl).getReader(),p=performance.now();for(;;){let{done:g,value:x}=await v.read();if(g)break;performance.now()-p>jx&&(await wi(0,o.signal),p=performance.now()),x.id!==void 0&&(i=x.id);let M=JSON.parse(x.data);if(x.event==="trace"){let b=M;b.seq>s&&(s=b.seq,e.trace([b]))}else if(x.event==="progress")e.progress(M.progress??M);else if(e.job(M),x.event==="done")return}}catch(c){if(t.aborted)return;if(ro(c)){e.failed(c);return}}finally{clearTimeout(l),t.removeEventListener("abort",a)}e.connected(!1),await wi(r,t),r=Math.min(r*2,8e3)}}async function dm(n,e,t,i){let s,r=500;for(;!i.aborted;)try{if(s===void 0){let a=await Qx(i);await n(),s=a}let o=await Ut(`v1/changes?since=${s}&wait=20`,i);t(!0),r=500,s=o.next_since,o.changes.length>0&&e(o.changes)}catch(o){if(i.aborted||(t(!1),o instanceof Oi&&o.problem.status===401))return;await wi(r,i),r=Math.min(r*2,8e3)}}async function Qx(n){let e=async s=>(await Ut(`v1/changes?since=${s}&limit=1`,n)).changes.length>0,[t,i]=[-1,0];for(;await e(i);)[t,i]=[i,Math.max(1,i*4)];for(;i-t>1;){let s=Math.floor((t+i)/2);await e(s)?t=s:i=s}return i}var ev="uplot",tv="u-hz",nv="u-vt",iv="u-title",sv="u-wrap",rv="u-under",ov="u-over",av="u-axis",wr="u-off",lv="u-select",cv="u-cursor-x",uv="u-cursor-y",hv="u-cursor-pt",fv="u-legend",dv="u-live",pv="u-inline",mv="u-series",gv="u-marker",pm="u-label",_v="u-value",_a="width",xa="height";var mm="bottom",oo="left",zh="right",sf="#000",gm=sf+"0",Vh="mousemove",_m="mousedown",Gh="mouseup",xm="mouseenter",vm="mouseleave",ym="dblclick",xv="resize",vv="scroll",bm="change",Wl="dppxchange",rf="--",po=typeof window<"u",Yh=po?document:null,lo=po?window:null,yv=po?navigator:null,Tt,zl;function $h(){let n=devicePixelRatio;Tt!=n&&(Tt=n,zl&&Zh(bm,zl,$h),zl=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Tr(bm,zl,$h),lo.dispatchEvent(new CustomEvent(Wl)))}function ui(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Jh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Fi(n,e,t,i){let s=Yh.createElement(n);return e!=null&&ui(s,e),t?.insertBefore(s,i),s}function Ti(n,e){return Fi("div",n,e)}var Sm=new WeakMap;function ss(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Sm.get(n);r!=o&&(n.style.transform=r,Sm.set(n,r),e<0||t<0||e>i||t>s?ui(n,wr):Jh(n,wr))}var Mm=new WeakMap;function wm(n,e,t){let i=e+t,s=Mm.get(n);i!=s&&(Mm.set(n,i),n.style.background=e,n.style.borderColor=t)}var Tm=new WeakMap;function Am(n,e,t,i){let s=e+""+t,r=Tm.get(n);s!=r&&(Tm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var of={passive:!0},bv={...of,capture:!0};function Tr(n,e,t,i){e.addEventListener(n,t,i?bv:of)}function Zh(n,e,t,i){e.removeEventListener(n,t,of)}po&&$h();function Ui(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:hi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function eg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var tg=n=>n!=null,ng=n=>n!=null&&n>0,Yl=eg(tg),Sv=eg(ng);function Mv(n,e,t,i=0,s=!1){let r=s?Sv:Yl,o=s?ng:tg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function $l(n,e,t,i){let s=Rm(n),r=Rm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?xs:ig,a=s==1?hi:Ai,l=r==1?Ai:hi,c=a(o(yn(n))),u=l(o(yn(e))),h=co(t,c),f=co(t,u);return t==10&&(c<0&&(h=kt(h,-c)),u<0&&(f=kt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=ag(n,h),e=Jl(e,f)),[n,e]}function af(n,e,t,i){let s=$l(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var lf=.1,Em={mode:3,pad:lf},ya={pad:0,soft:null,mode:0},wv={min:ya,max:ya};function Xl(n,e,t,i){return Zl(t)?Cm(n,e,t):(ya.pad=t,ya.soft=i?0:null,ya.mode=i?3:0,Cm(n,e,wv))}function Mt(n,e){return n??e}function Tv(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Cm(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-Bt),l=Mt(s.hard,Bt),c=Mt(i.soft,Bt),u=Mt(s.soft,-Bt),h=Mt(i.mode,0),f=Mt(s.mode,0),d=e-n,_=xs(d),v=Kn(yn(n),yn(e)),p=xs(v),g=yn(p-_);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let x=d||v||1e3,M=xs(x),b=co(10,hi(M)),y=x*(d==0?n==0?.1:1:r),S=kt(ag(n-y,b/10),24),m=n>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:Bt,w=Kn(a,S<m&&n>=m?m:Bi(m,S)),I=x*(d==0?e==0?.1:1:o),P=kt(Jl(e+I,b/10),24),L=e<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-Bt,N=Bi(l,P>L&&e<=L?L:Kn(L,P));return w==N&&w==0&&(N=100),[w,N]}var Av=new Intl.NumberFormat(po?yv.language:"en-US"),cf=n=>Av.format(n),fi=Math,Hl=fi.PI,yn=fi.abs,hi=fi.floor,vn=fi.round,Ai=fi.ceil,Bi=fi.min,Kn=fi.max,co=fi.pow,Rm=fi.sign,xs=fi.log10,ig=fi.log2,Ev=(n,e=1)=>fi.sinh(n)*e,Hh=(n,e=1)=>fi.asinh(n/e),Bt=1/0;function Pm(n){return(xs((n^n>>31)-(n>>31))|0)+1}function Kh(n,e,t){return Bi(Kn(n,e),t)}function sg(n){return typeof n=="function"}function xt(n){return sg(n)?n:()=>n}var Cv=()=>{},rg=n=>n,og=(n,e)=>e,Rv=n=>null,Im=n=>!0,Lm=(n,e)=>n==e,Pv=/\.\d*?(?=9{6,}|0{6,})/gm,Ar=n=>{if(cg(n)||$s.has(n))return n;let e=`${n}`,t=e.match(Pv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ar(s)}e${r}`}return kt(n,i)};function Sr(n,e){return Ar(kt(Ar(n/e))*e)}function Jl(n,e){return Ar(Ai(Ar(n/e))*e)}function ag(n,e){return Ar(hi(Ar(n/e))*e)}function kt(n,e=0){if(cg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return vn(i)/t}var $s=new Map;function lg(n){return((""+n).split(".")[1]||"").length}function Sa(n,e,t,i){let s=[],r=i.map(lg);for(let o=e;o<t;o++){let a=yn(o),l=kt(co(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:kt(u,h);s.push(f),$s.set(f,h)}}return s}var ba={},uf=[],uo=[null,null],Ys=Array.isArray,cg=Number.isInteger,Iv=n=>n===void 0;function Dm(n){return typeof n=="string"}function Zl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Lv(n){return n!=null&&typeof n=="object"}var Dv=Object.getPrototypeOf(Uint8Array),ug="__proto__";function ho(n,e=Zl){let t;if(Ys(n)){let i=n.find(s=>s!=null);if(Ys(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=ho(n[s],e)}else t=n.slice()}else if(n instanceof Dv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ug&&(t[i]=ho(n[i],e))}else t=n;return t}function dn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=ug&&(Zl(n[s])?dn(n[s],ho(i[s])):n[s]=ho(i[s]))}return n}var Nv=0,Ov=1,Fv=2;function Uv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Bv(n,e){if(Vv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Gv(o[0])||(o=zv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:Ov,d=[];for(let _=0;_<u.length;_++){let v=u[_],p=r.get(l[_]);v===null?f!=Nv&&(h[p]=v,f==Fv&&d.push(p)):h[p]=v}Uv(h,d,s),i.push(h)}}return i}var kv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function zv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Vv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Gv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Kn(1,hi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var hg=["January","February","March","April","May","June","July","August","September","October","November","December"],fg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function dg(n){return n.slice(0,3)}var Hv=fg.map(dg),Wv=hg.map(dg),Xv={MMMM:hg,MMM:Wv,WWWW:fg,WWW:Hv};function ga(n){return(n<10?"0":"")+n}function qv(n){return(n<10?"00":n<100?"0":"")+n}var Yv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ga(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ga(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ga(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ga(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ga(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>qv(n.getMilliseconds())};function hf(n,e){e=e||Xv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Yv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var $v=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Jv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==$v?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var pg=n=>n%1==0,ql=[1,2,2.5,5],Zv=Sa(10,-32,0,ql),mg=Sa(10,0,32,ql),Kv=mg.filter(pg),Mr=Zv.concat(mg),ff=`
`,gg="{YYYY}",Nm=ff+gg,_g="{M}/{D}",va=ff+_g,Vl=va+"/{YY}",xg="{aa}",jv="{h}:{mm}",ao=jv+xg,Om=ff+ao,Fm=":{ss}",Et=null;function vg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Sa(10,0,3,ql).filter(pg):Sa(10,-3,0,ql)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,gg,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Nm,Et,Et,Et,Et,Et,1],[s,_g,Nm,Et,Et,Et,Et,Et,1],[i,"{h}"+xg,Vl,Et,va,Et,Et,Et,1],[t,ao,Vl,Et,va,Et,Et,Et,1],[e,Fm,Vl+" "+ao,Et,va+" "+ao,Et,Om,Et,1],[n,Fm+".{fff}",Vl+" "+ao,Et,va+" "+ao,Et,Om,Et,1]];function u(h){return(f,d,_,v,p,g)=>{let x=[],M=p>=o,b=p>=r&&p<o,y=h(_),S=kt(y*n,3),m=Wh(y.getFullYear(),M?0:y.getMonth(),b||M?1:y.getDate()),w=kt(m*n,3);if(b||M){let I=b?p/r:0,P=M?p/o:0,L=S==w?S:kt(Wh(m.getFullYear()+P,m.getMonth()+I,1)*n,3),N=new Date(vn(L/n)),B=N.getFullYear(),D=N.getMonth();for(let G=0;L<=v;G++){let J=Wh(B+P*G,D+I*G,1),k=J-h(kt(J*n,3));L=kt((+J+k)*n,3),L<=v&&x.push(L)}}else{let I=p>=s?s:p,P=hi(_)-hi(S),L=w+P+Jl(S-w,I);x.push(L);let N=h(L),B=N.getHours()+N.getMinutes()/t+N.getSeconds()/i,D=p/i,G=f.axes[d]._space,J=g/G;for(;L=kt(L+p,n==1?0:3),!(L>v);)if(D>1){let k=hi(kt(B+D,6))%24,K=h(L).getHours()-k;K>1&&(K=-1),L-=K*i,B=(B+D)%24;let q=x[x.length-1];kt((L-q)/p,3)*J>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,u]}var[Qv,ey,ty]=vg(1),[ny,iy,sy]=vg(.001);Sa(2,-53,53,[1]);function Um(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Bm(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,f,d;return i.map(_=>{let v=n(_),p=v.getFullYear(),g=v.getMonth(),x=v.getDate(),M=v.getHours(),b=v.getMinutes(),y=v.getSeconds(),S=p!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||M!=h&&a[5]||b!=f&&a[6]||y!=d&&a[7]||a[1];return l=p,c=g,u=x,h=M,f=b,d=y,S(v)})}}function ry(n,e){let t=hf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Wh(n,e,t){return new Date(n,e,t)}function km(n,e){return e(n)}var oy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zm(n,e){return(t,i,s,r)=>r==null?rf:e(n(i))}function ay(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function ly(n,e){return n.series[e].fill(n,e)}var cy={show:!0,live:!0,isolate:!1,mount:Cv,markers:{show:!0,width:2,stroke:ay,fill:ly,dash:"solid"},idx:null,idxs:null,values:[]};function uy(n,e){let t=n.cursor.points,i=Ti(),s=t.size(n,e);qt(i,_a,s),qt(i,xa,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function hy(n,e){let t=n.series[e].points;return t._fill||t._stroke}function fy(n,e){let t=n.series[e].points;return t._stroke||t._fill}function dy(n,e){return n.series[e].points.size}var Xh=[0,0];function py(n,e,t){return Xh[0]=e,Xh[1]=t,Xh}function Gl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function qh(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var my={show:!0,x:!0,y:!0,lock:!1,move:py,points:{one:!1,show:uy,size:dy,width:0,stroke:fy,fill:hy},bind:{mousedown:Gl,mouseup:Gl,click:Gl,dblclick:Gl,mousemove:qh,mouseleave:qh,mouseenter:qh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},yg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},df=dn({},yg,{filter:og}),bg=dn({},df,{size:10}),Sg=dn({},yg,{show:!1}),pf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Mg="bold "+pf,wg=1.5,Vm={show:!0,scale:"x",stroke:sf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Mg,side:2,grid:df,ticks:bg,border:Sg,font:pf,lineGap:wg,rotate:0},gy="Value",_y="Time",Gm={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function xy(n,e,t,i,s){return e.map(r=>r==null?"":cf(r))}function vy(n,e,t,i,s,r,o){let a=[],l=$s.get(s)||0;t=o?t:kt(Jl(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function jh(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?xs:ig,u=hi(c(t));s=co(l,u),l==10&&(s=Mr[Ui(s,Mr)]);let h=t,f=s*l;l==10&&(f=Mr[Ui(f,Mr)]);do a.push(h),h=h+s,l==10&&!$s.has(h)&&(h=kt(h,$s.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Mr[Ui(f,Mr)]));while(h<=i);return a}function yy(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?jh(n,e,Kn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?jh(n,e,Kn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var Tg=/./,by=/[12357]/,Sy=/[125]/,Hm=/1/,Qh=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function My(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Tg:l(7,o)-u>=c?by:l(5,o)-u>=c?Sy:Hm;if(h==Hm){let f=yn(l(1,o)-u);if(f<c)return Qh(e.slice().reverse(),a.distr,h,Ai(c/f)).reverse()}return Qh(e,a.distr,h,1)}function wy(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=yn(l(1,o)-l(2,o));return c<a?Qh(e.slice().reverse(),3,Tg,Ai(a/c)).reverse():e}function Ty(n,e,t,i){return i==null?rf:e==null?"":cf(e)}var Wm={show:!0,scale:"y",stroke:sf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Mg,side:3,grid:df,ticks:bg,border:Sg,font:pf,lineGap:wg,rotate:0};function Ay(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Ey(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=yn(o-r),l=n.series[e],c=a/(l.points.space*Tt);return i[1]-i[0]<=c}var Xm={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Ag=(n,e,t,i,s)=>s,qm={show:!0,auto:!0,sorted:0,gaps:Ag,alpha:1,facets:[dn({},Xm,{scale:"x"}),dn({},Xm,{scale:"y"})]},Ym={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ag,alpha:1,points:{show:Ey,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function Cy(n,e,t,i,s){return t/10}var Eg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ry=dn({},Eg,{time:!1,ori:1}),$m={};function Cg(n,e){let t=$m[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&($m[n]=t)),t}var fo=1,ef=2;function Er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,_=a.width,v=a.height,p=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,h,p,g,f,d,_,v,jl,mo,ec,Pg,Lg):t(s,l,c,u,h,g,p,d,f,v,_,Ql,go,_f,Ig,Dg)}function mf(n,e){let t=0,i=0,s=Mt(n.bands,uf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Py(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function vs(n,e,t,i,s,r){return Er(n,e,(o,a,l,c,u,h,f,d,_,v,p)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?mo:go,b,y;x==1?(b=t,y=i):(b=i,y=t);let S=g(h(a[b],c,v,d)),m=g(f(l[b],u,p,_)),w=g(h(a[y],c,v,d)),I=g(f(r==1?u.max:u.min,u,p,_)),P=new Path2D(s);return M(P,w,I),M(P,S,I),M(P,S,m),P})}function Kl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ec:_f,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Iy(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function gf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),_=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let g=f+s;_=o>=0&&g>=0&&g<l?r(n[g]):_,_>=d&&a.push([d,_])}return a}function Jm(n){return n==0?rg:n==1?vn:e=>Sr(e,n)}function Rg(n){let e=n==0?jl:Ql,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Bi(c,a/2,l/2),u=Bi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var jl=(n,e,t)=>{n.moveTo(e,t)},Ql=(n,e,t)=>{n.moveTo(t,e)},mo=(n,e,t)=>{n.lineTo(e,t)},go=(n,e,t)=>{n.lineTo(t,e)},ec=Rg(0),_f=Rg(1),Pg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Ig=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Lg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Dg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Ng(n){return(e,t,i,s,r)=>Er(e,t,(o,a,l,c,u,h,f,d,_,v,p)=>{let{pxRound:g,points:x}=o,M,b;c.ori==0?(M=jl,b=Pg):(M=Ql,b=Ig);let y=kt(x.width*Tt,3),S=(x.size-x.width)/2*Tt,m=kt(S*2,3),w=new Path2D,I=new Path2D,{left:P,top:L,width:N,height:B}=e.bbox;ec(I,P-m,L-m,N+m*2,B+m*2);let D=G=>{if(l[G]!=null){let J=g(h(a[G],c,v,d)),k=g(f(l[G],u,p,_));M(w,J+S,k),b(w,J,k,S,0,Hl*2)}};if(r)r.forEach(D);else for(let G=i;G<=s;G++)D(G);return{stroke:y>0?w:null,fill:w,clip:I,flags:fo|ef}})}function Og(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Ly=Og(mo),Dy=Og(go);function Fg(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>Er(t,i,(o,a,l,c,u,h,f,d,_,v,p)=>{[s,r]=Yl(l,s,r);let g=o.pxRound,x=B=>g(h(B,c,v,d)),M=B=>g(f(B,u,p,_)),b,y;c.ori==0?(b=mo,y=Ly):(b=go,y=Dy);let S=c.dir*(c.ori==0?1:-1),m={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},w=m.stroke,I=!1;if(r-s>=v*4){let B=ne=>t.posToVal(ne,c.key,!0),D=null,G=null,J,k,se,Y=x(a[S==1?s:r]),K=x(a[s]),q=x(a[r]),ie=B(S==1?K+1:q-1);for(let ne=S==1?s:r;ne>=s&&ne<=r;ne+=S){let j=a[ne],pe=(S==1?j<ie:j>ie)?Y:x(j),_e=l[ne];pe==Y?_e!=null?(k=_e,D==null?(b(w,pe,M(k)),J=D=G=k):k<D?D=k:k>G&&(G=k)):_e===null&&(I=!0):(D!=null&&y(w,Y,M(D),M(G),M(J),M(k)),_e!=null?(k=_e,b(w,pe,M(k)),D=G=J=k):(D=G=null,_e===null&&(I=!0)),Y=pe,ie=B(Y+S))}D!=null&&D!=G&&se!=Y&&y(w,Y,M(D),M(G),M(J),M(k))}else for(let B=S==1?s:r;B>=s&&B<=r;B+=S){let D=l[B];D===null?I=!0:D!=null&&b(w,x(a[B]),M(D))}let[L,N]=mf(t,i);if(o.fill!=null||L!=0){let B=m.fill=new Path2D(w),D=o.fillTo(t,i,o.min,o.max,L),G=M(D),J=x(a[s]),k=x(a[r]);S==-1&&([k,J]=[J,k]),b(B,k,G),b(B,J,G)}if(!o.spanGaps){let B=[];I&&B.push(...gf(a,l,s,r,S,x,e)),m.gaps=B=o.gaps(t,i,s,r,B),m.clip=Kl(B,c.ori,d,_,v,p)}return N!=0&&(m.band=N==2?[vs(t,i,s,r,w,-1),vs(t,i,s,r,w,1)]:vs(t,i,s,r,w,N)),m})}function Ny(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>Er(r,o,(c,u,h,f,d,_,v,p,g,x,M)=>{[a,l]=Yl(h,a,l);let b=c.pxRound,{left:y,width:S}=r.bbox,m=K=>b(_(K,f,x,p)),w=K=>b(v(K,d,M,g)),I=f.ori==0?mo:go,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},L=P.stroke,N=f.dir*(f.ori==0?1:-1),B=w(h[N==1?a:l]),D=m(u[N==1?a:l]),G=D,J=D;s&&e==-1&&(J=y,I(L,J,B)),I(L,D,B);for(let K=N==1?a:l;K>=a&&K<=l;K+=N){let q=h[K];if(q==null)continue;let ie=m(u[K]),ne=w(q);e==1?I(L,ie,B):I(L,G,ne),I(L,ie,ne),B=ne,G=ie}let k=G;s&&e==1&&(k=y+S,I(L,k,B));let[se,Y]=mf(r,o);if(c.fill!=null||se!=0){let K=P.fill=new Path2D(L),q=c.fillTo(r,o,c.min,c.max,se),ie=w(q);I(K,k,ie),I(K,J,ie)}if(!c.spanGaps){let K=[];K.push(...gf(u,h,a,l,N,m,i));let q=c.width*Tt/2,ie=t||e==1?q:-q,ne=t||e==-1?-q:q;K.forEach(j=>{j[0]+=ie,j[1]+=ne}),P.gaps=K=c.gaps(r,o,a,l,K),P.clip=Kl(K,f.ori,p,g,x,M)}return Y!=0&&(P.band=Y==2?[vs(r,o,a,l,L,-1),vs(r,o,a,l,L,1)]:vs(r,o,a,l,L,Y)),P})}function Zm(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=yn(n[l]-n[a]);u<c&&(c=u,o=yn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Oy(n){n=n||ba;let e=Mt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xt(s),o=1-e[0],a=Mt(e[1],Bt),l=Mt(e[2],1),c=Mt(n.disp,ba),u=Mt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,_,v,p)=>Er(d,_,(g,x,M,b,y,S,m,w,I,P,L)=>{let N=g.pxRound,B=t,D=i*Tt,G=a*Tt,J=l*Tt,k,se;b.ori==0?[k,se]=r(d,_):[se,k]=r(d,_);let Y=b.dir*(b.ori==0?1:-1),K=b.ori==0?ec:_f,q=b.ori==0?u:(Re,Je,ot,we,Ot,Ve,qe)=>{u(Re,Je,ot,Ot,we,qe,Ve)},ie=Mt(d.bands,uf).find(Re=>Re.series[0]==_),ne=ie!=null?ie.dir:0,j=g.fillTo(d,_,g.min,g.max,ne),he=N(m(j,y,L,I)),pe,_e,xe,Ge=P,rt=N(g.width*Tt),He=!1,ft=null,ct=null,it=null,$t=null;h!=null&&(rt==0||f!=null)&&(He=!0,ft=h.values(d,_,v,p),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),rt>0&&(it=f.values(d,_,v,p),$t=new Map,new Set(it).forEach(Re=>{Re!=null&&$t.set(Re,new Path2D)})));let{x0:Vt,size:on}=c;if(Vt!=null&&on!=null){B=1,x=Vt.values(d,_,v,p),Vt.unit==2&&(x=x.map(ot=>d.posToVal(w+ot*P,b.key,!0)));let Re=on.values(d,_,v,p);on.unit==2?_e=Re[0]*P:_e=S(Re[0],b,P,w)-S(0,b,P,w),Ge=Zm(x,M,S,b,P,w,Ge),xe=Ge-_e+D}else Ge=Zm(x,M,S,b,P,w,Ge),xe=Ge*o+D,_e=Ge-xe;xe<1&&(xe=0),rt>=_e/2&&(rt=0),xe<5&&(N=rg);let Dt=xe>0,wn=Ge-xe-(Dt?rt:0);_e=N(Kh(wn,J,G)),pe=(B==0?_e/2:B==Y?0:_e)-B*Y*((B==0?D/2:0)+(Dt?rt/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},mn=He?null:new Path2D,jt=null;if(ie!=null)jt=d.data[ie.series[1]];else{let{y0:Re,y1:Je}=c;Re!=null&&Je!=null&&(M=Je.values(d,_,v,p),jt=Re.values(d,_,v,p))}let an=k*_e,V=se*_e;for(let Re=Y==1?v:p;Re>=v&&Re<=p;Re+=Y){let Je=M[Re];if(Je==null)continue;if(jt!=null){let $=jt[Re]??0;if(Je-$==0)continue;he=m($,y,L,I)}let ot=b.distr!=2||c!=null?x[Re]:Re,we=S(ot,b,P,w),Ot=m(Mt(Je,j),y,L,I),Ve=N(we-pe),qe=N(Kn(Ot,he)),O=N(Bi(Ot,he)),E=qe-O;if(Je!=null){let $=Je<0?V:an,de=Je<0?an:V;He?(rt>0&&it[Re]!=null&&K($t.get(it[Re]),Ve,O+hi(rt/2),_e,Kn(0,E-rt),$,de),ft[Re]!=null&&K(ct.get(ft[Re]),Ve,O+hi(rt/2),_e,Kn(0,E-rt),$,de)):K(mn,Ve,O+hi(rt/2),_e,Kn(0,E-rt),$,de),q(d,_,Re,Ve-rt/2,O,_e+rt,E)}}return rt>0?bt.stroke=He?$t:mn:He||(bt._fill=g.width==0?g._fill:g._stroke??g._fill,bt.width=0),bt.fill=He?ct:mn,bt})}function Fy(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>Er(i,s,(a,l,c,u,h,f,d,_,v,p,g)=>{[r,o]=Yl(c,r,o);let x=a.pxRound,M=k=>x(f(k,u,p,_)),b=k=>x(d(k,h,g,v)),y,S,m;u.ori==0?(y=jl,m=mo,S=Lg):(y=Ql,m=go,S=Dg);let w=u.dir*(u.ori==0?1:-1),I=M(l[w==1?r:o]),P=I,L=[],N=[];for(let k=w==1?r:o;k>=r&&k<=o;k+=w)if(c[k]!=null){let Y=l[k],K=M(Y);L.push(P=K),N.push(b(c[k]))}let B={stroke:n(L,N,y,m,S,x),fill:null,clip:null,band:null,gaps:null,flags:fo},D=B.stroke,[G,J]=mf(i,s);if(a.fill!=null||G!=0){let k=B.fill=new Path2D(D),se=a.fillTo(i,s,a.min,a.max,G),Y=b(se);m(k,P,Y),m(k,I,Y)}if(!a.spanGaps){let k=[];k.push(...gf(l,c,r,o,w,M,t)),B.gaps=k=a.gaps(i,s,r,o,k),B.clip=Kl(k,u.ori,_,v,p,g)}return J!=0&&(B.band=J==2?[vs(i,s,r,o,D,-1),vs(i,s,r,o,D,1)]:vs(i,s,r,o,D,J)),B})}function Uy(n){return Fy(By,n)}function By(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var tf=new Set;function Km(){for(let n of tf)n.syncRect(!0)}po&&(Tr(xv,lo,Km),Tr(vv,lo,Km,!0),Tr(Wl,lo,()=>{In.pxRatio=Tt}));var ky=Fg(),zy=Ng();function jm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>nf(r,o,e,t))}function Vy(n,e){return n.map((t,i)=>i==0?{}:dn({},e,t))}function nf(n,e,t,i){return dn({},e==0?t:i,n)}function Ug(n,e,t){return e==null?uo:[e,t]}var Gy=Ug;function Hy(n,e,t){return e==null?uo:Xl(e,t,lf,!0)}function Bg(n,e,t,i){return e==null?uo:$l(e,t,n.scales[i].log,!1)}var Wy=Bg;function kg(n,e,t,i){return e==null?uo:af(e,t,n.scales[i].log,!1)}var Xy=kg;function qy(n,e,t,i,s){let r=Kn(Pm(n),Pm(e)),o=e-n,a=Ui(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?$s.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Qm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=vn((t=+s)*Tt))+"px"),[n,e,t]}function Yy(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(T,C,F,U){let W=C.valToPct(T);return U+F*(C.dir==-1?1-W:W)}function o(T,C,F,U){let W=C.valToPct(T);return U+F*(C.dir==-1?W:1-W)}function a(T,C,F,U){return C.ori==0?r(T,C,F,U):o(T,C,F,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ti(ev);if(n.id!=null&&(c.id=n.id),ui(c,n.class),n.title){let T=Ti(iv,c);T.textContent=n.title}let u=Fi("canvas"),h=i.ctx=u.getContext("2d"),f=Ti(sv,c);Tr("click",f,T=>{T.target===_&&(Ht!=Zr||Jt!=Kr)&&Fn.click(i,T)},!0);let d=i.under=Ti(rv,f);f.appendChild(u);let _=i.over=Ti(ov,f);n=ho(n);let v=+Mt(n.pxAlign,1),p=Jm(v);(n.plugins||[]).forEach(T=>{T.opts&&(n=T.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?jm(n.series||[],Gm,Ym,!1):Vy(n.series||[null],qm),M=i.axes=jm(n.axes||[],Vm,Wm,!0),b=i.scales={},y=i.bands=n.bands||[];y.forEach(T=>{T.fill=xt(T.fill||null),T.dir=Mt(T.dir,-1)});let S=s==2?x[1].facets[0].scale:x[0].scale,m={axes:ms,series:pt},w=(n.drawOrder||["axes","series"]).map(T=>m[T]);function I(T){let C=T.distr==3?F=>xs(F>0?F:T.clamp(i,F,T.min,T.max,T.key)):T.distr==4?F=>Hh(F,T.asinh):T.distr==100?F=>T.fwd(F):F=>F;return F=>{let U=C(F),{_min:W,_max:ee}=T,ue=ee-W;return(U-W)/ue}}function P(T){let C=b[T];if(C==null){let F=(n.scales||ba)[T]||ba;if(F.from!=null){P(F.from);let U=dn({},b[F.from],F,{key:T});U.valToPct=I(U),b[T]=U}else{C=b[T]=dn({},T==S?Eg:Ry,F),C.key=T;let U=C.time,W=C.range,ee=Ys(W);if((T!=S||s==2&&!U)&&(ee&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Em:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Em:{mode:1,hard:W[1],soft:W[1]}},ee=!1),!ee&&Zl(W))){let ue=W;W=(me,Se,De)=>Se==null?uo:Xl(Se,De,ue)}C.range=xt(W||(U?Gy:T==S?C.distr==3?Wy:C.distr==4?Xy:Ug:C.distr==3?Bg:C.distr==4?kg:Hy)),C.auto=xt(ee?!1:C.auto),C.clamp=xt(C.clamp||Cy),C._min=C._max=null,C.valToPct=I(C)}}}P("x"),P("y"),s==1&&x.forEach(T=>{P(T.scale)}),M.forEach(T=>{P(T.scale)});for(let T in n.scales)P(T);let L=b[S],N=L.distr,B,D;L.ori==0?(ui(c,tv),B=r,D=o):(ui(c,nv),B=o,D=r);let G={};for(let T in b){let C=b[T];(C.min!=null||C.max!=null)&&(G[T]={min:C.min,max:C.max},C.min=C.max=null)}let J=n.tzDate||(T=>new Date(vn(T/g))),k=n.fmtDate||hf,se=g==1?ty(J):sy(J),Y=Bm(J,Um(g==1?ey:iy,k)),K=zm(J,km(oy,k)),q=[],ie=i.legend=dn({},cy,n.legend),ne=i.cursor=dn({},my,{drag:{y:s==2}},n.cursor),j=ie.show,he=ne.show,pe=ie.markers;ie.idxs=q,pe.width=xt(pe.width),pe.dash=xt(pe.dash),pe.stroke=xt(pe.stroke),pe.fill=xt(pe.fill);let _e,xe,Ge,rt=[],He=[],ft,ct=!1,it={};if(ie.live){let T=x[1]?x[1].values:null;ct=T!=null,ft=ct?T(i,1,0):{_:0};for(let C in ft)it[C]=rf}if(j)if(_e=Fi("table",fv,c),Ge=Fi("tbody",null,_e),ie.mount(i,_e),ct){xe=Fi("thead",null,_e,Ge);let T=Fi("tr",null,xe);Fi("th",null,T);for(var $t in ft)Fi("th",pm,T).textContent=$t}else ui(_e,pv),ie.live&&ui(_e,dv);let Vt={show:!0},on={show:!1};function Dt(T,C){if(C==0&&(ct||!ie.live||s==2))return uo;let F=[],U=Fi("tr",mv,Ge,Ge.childNodes[C]);ui(U,T.class),T.show||ui(U,wr);let W=Fi("th",null,U);if(pe.show){let me=Ti(gv,W);if(C>0){let Se=pe.width(i,C);Se&&(me.style.border=Se+"px "+pe.dash(i,C)+" "+pe.stroke(i,C)),me.style.background=pe.fill(i,C)}}let ee=Ti(pm,W);T.label instanceof HTMLElement?ee.appendChild(T.label):ee.textContent=T.label,C>0&&(pe.show||(ee.style.color=T.width>0?pe.stroke(i,C):pe.fill(i,C)),bt("click",W,me=>{if(ne._lock)return;Ke(me);let Se=x.indexOf(T);if((me.ctrlKey||me.metaKey)!=ie.isolate){let De=x.some((Ne,Ue)=>Ue>0&&Ue!=Se&&Ne.show);x.forEach((Ne,Ue)=>{Ue>0&&Qi(Ue,De?Ue==Se?Vt:on:Vt,!0,hn.setSeries)})}else Qi(Se,{show:!T.show},!0,hn.setSeries)},!1),je&&bt(xm,W,me=>{ne._lock||(Ke(me),Qi(x.indexOf(T),Qr,!0,hn.setSeries))},!1));for(var ue in ft){let me=Fi("td",_v,U);me.textContent="--",F.push(me)}return[U,F]}let wn=new Map;function bt(T,C,F,U=!0){let W=wn.get(C)||{},ee=ne.bind[T](i,C,F,U);ee&&(Tr(T,C,W[T]=ee),wn.set(C,W))}function mn(T,C,F){let U=wn.get(C)||{};for(let W in U)(T==null||W==T)&&(Zh(W,C,U[W]),delete U[W]);T==null&&wn.delete(C)}let jt=0,an=0,V=0,Re=0,Je=0,ot=0,we=Je,Ot=ot,Ve=V,qe=Re,O=0,E=0,$=0,de=0;i.bbox={};let ce=!1,ye=!1,be=!1,re=!1,ae=!1,ge=!1;function z(T,C,F){(F||T!=i.width||C!=i.height)&&le(T,C),ut(!1),be=!0,ye=!0,kn()}function le(T,C){i.width=jt=V=T,i.height=an=Re=C,Je=ot=0,Me(),We();let F=i.bbox;O=F.left=Sr(Je*Tt,.5),E=F.top=Sr(ot*Tt,.5),$=F.width=Sr(V*Tt,.5),de=F.height=Sr(Re*Tt,.5)}let oe=3;function Te(){let T=!1,C=0;for(;!T;){C++;let F=Yr(C),U=ji(C);T=C==oe||F&&U,T||(le(i.width,i.height),ye=!0)}}function ve({width:T,height:C}){z(T,C)}i.setSize=ve;function Me(){let T=!1,C=!1,F=!1,U=!1;M.forEach((W,ee)=>{if(W.show&&W._show){let{side:ue,_size:me}=W,Se=ue%2,De=W.label!=null?W.labelSize:0,Ne=me+De;Ne>0&&(Se?(V-=Ne,ue==3?(Je+=Ne,U=!0):F=!0):(Re-=Ne,ue==0?(ot+=Ne,T=!0):C=!0))}}),Zi[0]=T,Zi[1]=F,Zi[2]=C,Zi[3]=U,V-=Li[1]+Li[3],Je+=Li[3],Re-=Li[2]+Li[0],ot+=Li[0]}function We(){let T=Je+V,C=ot+Re,F=Je,U=ot;function W(ee,ue){switch(ee){case 1:return T+=ue,T-ue;case 2:return C+=ue,C-ue;case 3:return F-=ue,F+ue;case 0:return U-=ue,U+ue}}M.forEach((ee,ue)=>{if(ee.show&&ee._show){let me=ee.side;ee._pos=W(me,ee._size),ee.label!=null&&(ee._lpos=W(me,ee.labelSize))}})}if(ne.dataIdx==null){let T=ne.hover,C=T.skip=new Set(T.skip??[]);C.add(void 0);let F=T.prox=xt(T.prox),U=T.bias??=0;ne.dataIdx=(W,ee,ue,me)=>{if(ee==0)return ue;let Se=ue,De=F(W,ee,ue,me)??Bt,Ne=De>=0&&De<Bt,Ue=L.ori==0?V:Re,st=ne.left,wt=e[0],St=e[ee];if(C.has(St[ue])){Se=null;let mt=null,Ze=null,Xe;if(U==0||U==-1)for(Xe=ue;mt==null&&Xe-- >0;)C.has(St[Xe])||(mt=Xe);if(U==0||U==1)for(Xe=ue;Ze==null&&Xe++<St.length;)C.has(St[Xe])||(Ze=Xe);if(mt!=null||Ze!=null)if(Ne){let Xt=mt==null?-1/0:B(wt[mt],L,Ue,0),tn=Ze==null?1/0:B(wt[Ze],L,Ue,0),Cn=st-Xt,Nt=tn-st;Cn<=Nt?Cn<=De&&(Se=mt):Nt<=De&&(Se=Ze)}else Se=Ze==null?mt:mt==null?Ze:ue-mt<=Ze-ue?mt:Ze}else Ne&&yn(st-B(wt[ue],L,Ue,0))>De&&(Se=null);return Se}}let Ke=T=>{ne.event=T};ne.idxs=q,ne._lock=!1;let fe=ne.points;fe.show=xt(fe.show),fe.size=xt(fe.size),fe.stroke=xt(fe.stroke),fe.width=xt(fe.width),fe.fill=xt(fe.fill);let Be=i.focus=dn({},n.focus||{alpha:.3},ne.focus),je=Be.prox>=0,Ce=je&&fe.one,lt=[],Gt=[],Wn=[];function ea(T,C){let F=fe.show(i,C);if(F instanceof HTMLElement)return ui(F,hv),ui(F,T.class),ss(F,-10,-10,V,Re),_.insertBefore(F,lt[C]),F}function Wr(T,C){if(s==1||C>0){let F=s==1&&b[T.scale].time,U=T.value;T.value=F?Dm(U)?zm(J,km(U,k)):U||K:U||Ty,T.label=T.label||(F?_y:gy)}if(Ce||C>0){T.width=T.width==null?1:T.width,T.paths=T.paths||ky||Rv,T.fillTo=xt(T.fillTo||Py),T.pxAlign=+Mt(T.pxAlign,v),T.pxRound=Jm(T.pxAlign),T.stroke=xt(T.stroke||null),T.fill=xt(T.fill||null),T._stroke=T._fill=T._paths=T._focus=null;let F=Ay(Kn(1,T.width),1),U=T.points=dn({},{size:F,width:Kn(1,F*.2),stroke:T.stroke,space:F*2,paths:zy,_stroke:null,_fill:null},T.points);U.show=xt(U.show),U.filter=xt(U.filter),U.fill=xt(U.fill),U.stroke=xt(U.stroke),U.paths=xt(U.paths),U.pxAlign=T.pxAlign}if(j){let F=Dt(T,C);rt.splice(C,0,F[0]),He.splice(C,0,F[1]),ie.values.push(null)}if(he){q.splice(C,0,null);let F=null;Ce?C==0&&(F=ea(T,C)):C>0&&(F=ea(T,C)),lt.splice(C,0,F),Gt.splice(C,0,0),Wn.splice(C,0,0)}En("addSeries",C)}function hh(T,C){C=C??x.length,T=s==1?nf(T,C,Gm,Ym):nf(T,C,{},qm),x.splice(C,0,T),Wr(x[C],C)}i.addSeries=hh;function yl(T){if(x.splice(T,1),j){ie.values.splice(T,1),He.splice(T,1);let C=rt.splice(T,1)[0];mn(null,C.firstChild),C.remove()}he&&(q.splice(T,1),lt.splice(T,1)[0].remove(),Gt.splice(T,1),Wn.splice(T,1)),En("delSeries",T)}i.delSeries=yl;let Zi=[!1,!1,!1,!1];function fs(T,C){if(T._show=T.show,T.show){let F=T.side%2,U=b[T.scale];U==null&&(T.scale=F?x[1].scale:S,U=b[T.scale]);let W=U.time;T.size=xt(T.size),T.space=xt(T.space),T.rotate=xt(T.rotate),Ys(T.incrs)&&T.incrs.forEach(ue=>{!$s.has(ue)&&$s.set(ue,lg(ue))}),T.incrs=xt(T.incrs||(U.distr==2?Kv:W?g==1?Qv:ny:Mr)),T.splits=xt(T.splits||(W&&U.distr==1?se:U.distr==3?jh:U.distr==4?yy:vy)),T.stroke=xt(T.stroke),T.grid.stroke=xt(T.grid.stroke),T.ticks.stroke=xt(T.ticks.stroke),T.border.stroke=xt(T.border.stroke);let ee=T.values;T.values=Ys(ee)&&!Ys(ee[0])?xt(ee):W?Ys(ee)?Bm(J,Um(ee,k)):Dm(ee)?ry(J,ee):ee||Y:ee||xy,T.filter=xt(T.filter||(U.distr>=3&&U.log==10?My:U.distr==3&&U.log==2?wy:og)),T.font=Qm(T.font),T.labelFont=Qm(T.labelFont),T._size=T.size(i,null,C,0),T._space=T._rotate=T._incrs=T._found=T._splits=T._values=null,T._size>0&&(Zi[C]=!0,T._el=Ti(av,f))}}function ds(T,C,F,U){let[W,ee,ue,me]=F,Se=C%2,De=0;return Se==0&&(me||ee)&&(De=C==0&&!W||C==2&&!ue?vn(Vm.size/3):0),Se==1&&(W||ue)&&(De=C==1&&!ee||C==3&&!me?vn(Wm.size/2):0),De}let ta=i.padding=(n.padding||[ds,ds,ds,ds]).map(T=>xt(Mt(T,ds))),Li=i._padding=ta.map((T,C)=>T(i,C,Zi,0)),Qt,sn=null,rn=null,Ki=s==1?x[0].idxs:null,ri=null,Bs=!1;function na(T,C){if(e=T??[],i.data=i._data=e,s==2){Qt=0;for(let F=1;F<x.length;F++)Qt+=e[F][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ri=e[0],Qt=ri.length;let F=e;if(N==2){F=e.slice();let U=F[0]=Array(Qt);for(let W=0;W<Qt;W++)U[W]=W}i._data=e=F}if(ut(!0),En("setData"),N==2&&(be=!0),C!==!1){let F=L;F.auto(i,Bs)?ia():Vs(S,F.min,F.max),re=re||ne.left>=0,ge=!0,kn()}}i.setData=na;function ia(){Bs=!0;let T,C;s==1&&(Qt>0?(sn=Ki[0]=0,rn=Ki[1]=Qt-1,T=e[0][sn],C=e[0][rn],N==2?(T=sn,C=rn):T==C&&(N==3?[T,C]=$l(T,T,L.log,!1):N==4?[T,C]=af(T,T,L.log,!1):L.time?C=T+vn(86400/g):[T,C]=Xl(T,C,lf,!0))):(sn=Ki[0]=T=null,rn=Ki[1]=C=null)),Vs(S,T,C)}let Xr,ks,qr,R,H,te,Z,Q,Ae,Pe;function Ee(T,C,F,U,W,ee){T??=gm,F??=uf,U??="butt",W??=gm,ee??="round",T!=Xr&&(h.strokeStyle=Xr=T),W!=ks&&(h.fillStyle=ks=W),C!=qr&&(h.lineWidth=qr=C),ee!=H&&(h.lineJoin=H=ee),U!=te&&(h.lineCap=te=U),F!=R&&h.setLineDash(R=F)}function Ie(T,C,F,U){C!=ks&&(h.fillStyle=ks=C),T!=Z&&(h.font=Z=T),F!=Q&&(h.textAlign=Q=F),U!=Ae&&(h.textBaseline=Ae=U)}function ze(T,C,F,U,W=0){if(U.length>0&&T.auto(i,Bs)&&(C==null||C.min==null)){let ee=Mt(sn,0),ue=Mt(rn,U.length-1),me=F.min==null?Mv(U,ee,ue,W,T.distr==3):[F.min,F.max];T.min=Bi(T.min,F.min=me[0]),T.max=Kn(T.max,F.max=me[1])}}let et={min:null,max:null};function dt(){for(let U in b){let W=b[U];G[U]==null&&(W.min==null||G[S]!=null&&W.auto(i,Bs))&&(G[U]=et)}for(let U in b){let W=b[U];G[U]==null&&W.from!=null&&G[W.from]!=null&&(G[U]=et)}G[S]!=null&&ut(!0);let T={};for(let U in G){let W=G[U];if(W!=null){let ee=T[U]=ho(b[U],Lv);if(W.min!=null)dn(ee,W);else if(U!=S||s==2)if(Qt==0&&ee.from==null){let ue=ee.range(i,null,null,U);ee.min=ue[0],ee.max=ue[1]}else ee.min=Bt,ee.max=-Bt}}if(Qt>0){x.forEach((U,W)=>{if(s==1){let ee=U.scale,ue=G[ee];if(ue==null)return;let me=T[ee];if(W==0){let Se=me.range(i,me.min,me.max,ee);me.min=Se[0],me.max=Se[1],sn=Ui(me.min,e[0]),rn=Ui(me.max,e[0]),rn-sn>1&&(e[0][sn]<me.min&&sn++,e[0][rn]>me.max&&rn--),U.min=ri[sn],U.max=ri[rn]}else U.show&&U.auto&&ze(me,ue,U,e[W],U.sorted);U.idxs[0]=sn,U.idxs[1]=rn}else if(W>0&&U.show&&U.auto){let[ee,ue]=U.facets,me=ee.scale,Se=ue.scale,[De,Ne]=e[W],Ue=T[me],st=T[Se];Ue!=null&&ze(Ue,G[me],ee,De,ee.sorted),st!=null&&ze(st,G[Se],ue,Ne,ue.sorted),U.min=ue.min,U.max=ue.max}});for(let U in T){let W=T[U],ee=G[U];if(W.from==null&&(ee==null||ee.min==null)){let ue=W.range(i,W.min==Bt?null:W.min,W.max==-Bt?null:W.max,U);W.min=ue[0],W.max=ue[1]}}}for(let U in T){let W=T[U];if(W.from!=null){let ee=T[W.from];if(ee.min==null)W.min=W.max=null;else{let ue=W.range(i,ee.min,ee.max,U);W.min=ue[0],W.max=ue[1]}}}let C={},F=!1;for(let U in T){let W=T[U],ee=b[U];if(ee.min!=W.min||ee.max!=W.max){ee.min=W.min,ee.max=W.max;let ue=ee.distr;ee._min=ue==3?xs(ee.min):ue==4?Hh(ee.min,ee.asinh):ue==100?ee.fwd(ee.min):ee.min,ee._max=ue==3?xs(ee.max):ue==4?Hh(ee.max,ee.asinh):ue==100?ee.fwd(ee.max):ee.max,C[U]=F=!0}}if(F){x.forEach((U,W)=>{s==2?W>0&&C.y&&(U._paths=null):C[U.scale]&&(U._paths=null)});for(let U in C)be=!0,En("setScale",U);he&&ne.left>=0&&(re=ge=!0)}for(let U in G)G[U]=null}function ke(T){let C=Kh(sn-1,0,Qt-1),F=Kh(rn+1,0,Qt-1);for(;T[C]==null&&C>0;)C--;for(;T[F]==null&&F<Qt-1;)F++;return[C,F]}function pt(){if(Qt>0){let T=x.some(C=>C._focus)&&Pe!=Be.alpha;T&&(h.globalAlpha=Pe=Be.alpha),x.forEach((C,F)=>{if(F>0&&C.show&&(Kt(F,!1),Kt(F,!0),C._paths==null)){let U=Pe;Pe!=C.alpha&&(h.globalAlpha=Pe=C.alpha);let W=s==2?[0,e[F][0].length-1]:ke(e[F]);C._paths=C.paths(i,F,W[0],W[1]),Pe!=U&&(h.globalAlpha=Pe=U)}}),x.forEach((C,F)=>{if(F>0&&C.show){let U=Pe;Pe!=C.alpha&&(h.globalAlpha=Pe=C.alpha),C._paths!=null&&Rt(F,!1);{let W=C._paths!=null?C._paths.gaps:null,ee=C.points.show(i,F,sn,rn,W),ue=C.points.filter(i,F,ee,W);(ee||ue)&&(C.points._paths=C.points.paths(i,F,sn,rn,ue),Rt(F,!0))}Pe!=U&&(h.globalAlpha=Pe=U),En("drawSeries",F)}}),T&&(h.globalAlpha=Pe=1)}}function Kt(T,C){let F=C?x[T].points:x[T];F._stroke=F.stroke(i,T),F._fill=F.fill(i,T)}function Rt(T,C){let F=C?x[T].points:x[T],{stroke:U,fill:W,clip:ee,flags:ue,_stroke:me=F._stroke,_fill:Se=F._fill,_width:De=F.width}=F._paths;De=kt(De*Tt,3);let Ne=null,Ue=De%2/2;C&&Se==null&&(Se=De>0?"#fff":me);let st=F.pxAlign==1&&Ue>0;if(st&&h.translate(Ue,Ue),!C){let wt=O-De/2,St=E-De/2,mt=$+De,Ze=de+De;Ne=new Path2D,Ne.rect(wt,St,mt,Ze)}C?Fe(me,De,F.dash,F.cap,Se,U,W,ue,ee):Pt(T,me,De,F.dash,F.cap,Se,U,W,ue,Ne,ee),st&&h.translate(-Ue,-Ue)}function Pt(T,C,F,U,W,ee,ue,me,Se,De,Ne){let Ue=!1;Se!=0&&y.forEach((st,wt)=>{if(st.series[0]==T){let St=x[st.series[1]],mt=e[st.series[1]],Ze=(St._paths||ba).band;Ys(Ze)&&(Ze=st.dir==1?Ze[0]:Ze[1]);let Xe,Xt=null;St.show&&Ze&&Tv(mt,sn,rn)?(Xt=st.fill(i,wt)||ee,Xe=St._paths.clip):Ze=null,Fe(C,F,U,W,Xt,ue,me,Se,De,Ne,Xe,Ze),Ue=!0}}),Ue||Fe(C,F,U,W,ee,ue,me,Se,De,Ne)}let gn=fo|ef;function Fe(T,C,F,U,W,ee,ue,me,Se,De,Ne,Ue){Ee(T,C,F,U,W),(Se||De||Ue)&&(h.save(),Se&&h.clip(Se),De&&h.clip(De)),Ue?(me&gn)==gn?(h.clip(Ue),Ne&&h.clip(Ne),_t(W,ue),ln(T,ee,C)):me&ef?(_t(W,ue),h.clip(Ue),ln(T,ee,C)):me&fo&&(h.save(),h.clip(Ue),Ne&&h.clip(Ne),_t(W,ue),h.restore(),ln(T,ee,C)):(_t(W,ue),ln(T,ee,C)),(Se||De||Ue)&&h.restore()}function ln(T,C,F){F>0&&(C instanceof Map?C.forEach((U,W)=>{h.strokeStyle=Xr=W,h.stroke(U)}):C!=null&&T&&h.stroke(C))}function _t(T,C){C instanceof Map?C.forEach((F,U)=>{h.fillStyle=ks=U,h.fill(F)}):C!=null&&T&&h.fill(C)}function ps(T,C,F,U){let W=M[T],ee;if(U<=0)ee=[0,0];else{let ue=W._space=W.space(i,T,C,F,U),me=W._incrs=W.incrs(i,T,C,F,U,ue);ee=qy(C,F,me,U,ue)}return W._found=ee}function cn(T,C,F,U,W,ee,ue,me,Se,De){let Ne=ue%2/2;v==1&&h.translate(Ne,Ne),Ee(me,ue,Se,De,me),h.beginPath();let Ue,st,wt,St,mt=W+(U==0||U==3?-ee:ee);F==0?(st=W,St=mt):(Ue=W,wt=mt);for(let Ze=0;Ze<T.length;Ze++)C[Ze]!=null&&(F==0?Ue=wt=T[Ze]:st=St=T[Ze],h.moveTo(Ue,st),h.lineTo(wt,St));h.stroke(),v==1&&h.translate(-Ne,-Ne)}function Yr(T){let C=!0;return M.forEach((F,U)=>{if(!F.show)return;let W=b[F.scale];if(W.min==null){F._show&&(C=!1,F._show=!1,ut(!1));return}else F._show||(C=!1,F._show=!0,ut(!1));let ee=F.side,ue=ee%2,{min:me,max:Se}=W,[De,Ne]=ps(U,me,Se,ue==0?V:Re);if(Ne==0)return;let Ue=W.distr==2,st=F._splits=F.splits(i,U,me,Se,De,Ne,Ue),wt=W.distr==2?st.map(Xe=>ri[Xe]):st,St=W.distr==2?ri[st[1]]-ri[st[0]]:De,mt=F._values=F.values(i,F.filter(i,wt,U,Ne,St),U,Ne,St);F._rotate=ee==2?F.rotate(i,mt,U,Ne):0;let Ze=F._size;F._size=Ai(F.size(i,mt,U,T)),Ze!=null&&F._size!=Ze&&(C=!1)}),C}function ji(T){let C=!0;return ta.forEach((F,U)=>{let W=F(i,U,Zi,T);W!=Li[U]&&(C=!1),Li[U]=W}),C}function ms(){for(let T=0;T<M.length;T++){let C=M[T];if(!C.show||!C._show)continue;let F=C.side,U=F%2,W,ee,ue=C.stroke(i,T),me=F==0||F==3?-1:1,[Se,De]=C._found;if(C.label!=null){let Yn=C.labelGap*me,li=vn((C._lpos+Yn)*Tt);Ie(C.labelFont[0],ue,"center",F==2?"top":mm),h.save(),U==1?(W=ee=0,h.translate(li,vn(E+de/2)),h.rotate((F==3?-Hl:Hl)/2)):(W=vn(O+$/2),ee=li);let mr=sg(C.label)?C.label(i,T,Se,De):C.label;h.fillText(mr,W,ee),h.restore()}if(De==0)continue;let Ne=b[C.scale],Ue=U==0?$:de,st=U==0?O:E,wt=C._splits,St=Ne.distr==2?wt.map(Yn=>ri[Yn]):wt,mt=Ne.distr==2?ri[wt[1]]-ri[wt[0]]:Se,Ze=C.ticks,Xe=C.border,Xt=Ze.show?Ze.size:0,tn=vn(Xt*Tt),Cn=vn((C.alignTo==2?C._size-Xt-C.gap:C.gap)*Tt),Nt=C._rotate*-Hl/180,nn=p(C._pos*Tt),oi=(tn+Cn)*me,qn=nn+oi;ee=U==0?qn:0,W=U==1?qn:0;let xi=C.font[0],Di=C.align==1?oo:C.align==2?zh:Nt>0?oo:Nt<0?zh:U==0?"center":F==3?zh:oo,ts=Nt||U==1?"middle":F==2?"top":mm;Ie(xi,ue,Di,ts);let ai=C.font[1]*C.lineGap,vi=wt.map(Yn=>p(a(Yn,Ne,Ue,st))),Ni=C._values;for(let Yn=0;Yn<Ni.length;Yn++){let li=Ni[Yn];if(li!=null){U==0?W=vi[Yn]:ee=vi[Yn],li=""+li;let mr=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let $n=0;$n<mr.length;$n++){let _p=mr[$n];Nt?(h.save(),h.translate(W,ee+$n*ai),h.rotate(Nt),h.fillText(_p,0,0),h.restore()):h.fillText(_p,W,ee+$n*ai)}}}Ze.show&&cn(vi,Ze.filter(i,St,T,De,mt),U,F,nn,tn,kt(Ze.width*Tt,3),Ze.stroke(i,T),Ze.dash,Ze.cap);let ns=C.grid;ns.show&&cn(vi,ns.filter(i,St,T,De,mt),U,U==0?2:1,U==0?E:O,U==0?de:$,kt(ns.width*Tt,3),ns.stroke(i,T),ns.dash,ns.cap),Xe.show&&cn([nn],[1],U==0?1:0,U==0?1:2,U==1?E:O,U==1?de:$,kt(Xe.width*Tt,3),Xe.stroke(i,T),Xe.dash,Xe.cap)}En("drawAxes")}function ut(T){x.forEach((C,F)=>{F>0&&(C._paths=null,T&&(s==1?(C.min=null,C.max=null):C.facets.forEach(U=>{U.min=null,U.max=null})))})}let en=!1,Xn=!1,It=[];function un(){Xn=!1;for(let T=0;T<It.length;T++)En(...It[T]);It.length=0}function kn(){en||(kv(Qd),en=!0)}function bl(T,C=!1){en=!0,Xn=C,T(i),Qd(),C&&It.length>0&&queueMicrotask(un)}i.batch=bl;function Qd(){if(ce&&(dt(),ce=!1),be&&(Te(),be=!1),ye){if(qt(d,oo,Je),qt(d,"top",ot),qt(d,_a,V),qt(d,xa,Re),qt(_,oo,Je),qt(_,"top",ot),qt(_,_a,V),qt(_,xa,Re),qt(f,_a,jt),qt(f,xa,an),u.width=vn(jt*Tt),u.height=vn(an*Tt),M.forEach(({_el:T,_show:C,_size:F,_pos:U,side:W})=>{if(T!=null)if(C){let ee=W===3||W===0?F:0,ue=W%2==1;qt(T,ue?"left":"top",U-ee),qt(T,ue?"width":"height",F),qt(T,ue?"top":"left",ue?ot:Je),qt(T,ue?"height":"width",ue?Re:V),Jh(T,wr)}else ui(T,wr)}),Xr=ks=qr=H=te=Z=Q=Ae=R=null,Pe=1,oa(!0),Je!=we||ot!=Ot||V!=Ve||Re!=qe){ut(!1);let T=V/Ve,C=Re/qe;if(he&&!re&&ne.left>=0){ne.left*=T,ne.top*=C,$r&&ss($r,vn(ne.left),0,V,Re),Jr&&ss(Jr,0,vn(ne.top),V,Re);for(let F=0;F<lt.length;F++){let U=lt[F];U!=null&&(Gt[F]*=T,Wn[F]*=C,ss(U,Ai(Gt[F]),Ai(Wn[F]),V,Re))}}if(Wt.show&&!ae&&Wt.left>=0&&Wt.width>0){Wt.left*=T,Wt.width*=T,Wt.top*=C,Wt.height*=C;for(let F in _h)qt(jr,F,Wt[F])}we=Je,Ot=ot,Ve=V,qe=Re}En("setSize"),ye=!1}jt>0&&an>0&&(h.clearRect(0,0,u.width,u.height),En("drawClear"),w.forEach(T=>T()),En("draw")),Wt.show&&ae&&(Sl(Wt),ae=!1),he&&re&&(pr(null,!0,!1),re=!1),ie.show&&ie.live&&ge&&(mh(),ge=!1),l||(l=!0,i.status=1,En("ready")),Bs=!1,en=!1}i.redraw=(T,C)=>{be=C||!1,T!==!1?Vs(S,L.min,L.max):kn()};function fh(T,C){let F=b[T];if(F.from==null){if(Qt==0){let U=F.range(i,C.min,C.max,T);C.min=U[0],C.max=U[1]}if(C.min>C.max){let U=C.min;C.min=C.max,C.max=U}if(Qt>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;T==S&&F.distr==2&&Qt>0&&(C.min=Ui(C.min,e[0]),C.max=Ui(C.max,e[0]),C.min==C.max&&C.max++),G[T]=C,ce=!0,kn()}}i.setScale=fh;let dh,ph,$r,Jr,ep,tp,Zr,Kr,np,ip,Ht,Jt,zs=!1,Fn=ne.drag,Tn=Fn.x,An=Fn.y;he&&(ne.x&&(dh=Ti(cv,_)),ne.y&&(ph=Ti(uv,_)),L.ori==0?($r=dh,Jr=ph):($r=ph,Jr=dh),Ht=ne.left,Jt=ne.top);let Wt=i.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),jr=Wt.show?Ti(lv,Wt.over?_:d):null;function Sl(T,C){if(Wt.show){for(let F in T)Wt[F]=T[F],F in _h&&qt(jr,F,T[F]);C!==!1&&En("setSelect")}}i.setSelect=Sl;function px(T){if(x[T].show)j&&Jh(rt[T],wr);else if(j&&ui(rt[T],wr),he){let F=Ce?lt[0]:lt[T];F!=null&&ss(F,-10,-10,V,Re)}}function Vs(T,C,F){fh(T,{min:C,max:F})}function Qi(T,C,F,U){C.focus!=null&&vx(T),C.show!=null&&x.forEach((W,ee)=>{ee>0&&(T==ee||T==null)&&(W.show=C.show,px(ee),s==2?(Vs(W.facets[0].scale,null,null),Vs(W.facets[1].scale,null,null)):Vs(W.scale,null,null),kn())}),F!==!1&&En("setSeries",T,C),U&&aa("setSeries",i,T,C)}i.setSeries=Qi;function mx(T,C){dn(y[T],C)}function gx(T,C){T.fill=xt(T.fill||null),T.dir=Mt(T.dir,-1),C=C??y.length,y.splice(C,0,T)}function _x(T){T==null?y.length=0:y.splice(T,1)}i.addBand=gx,i.setBand=mx,i.delBand=_x;function xx(T,C){x[T].alpha=C,he&&lt[T]!=null&&(lt[T].style.opacity=C),j&&rt[T]&&(rt[T].style.opacity=C)}let gs,Gs,dr,Qr={focus:!0};function vx(T){if(T!=dr){let C=T==null,F=Be.alpha!=1;x.forEach((U,W)=>{if(s==1||W>0){let ee=C||W==0||W==T;U._focus=C?null:ee,F&&xx(W,ee?1:Be.alpha)}}),dr=T,F&&kn()}}j&&je&&bt(vm,_e,T=>{ne._lock||(Ke(T),dr!=null&&Qi(null,Qr,!0,hn.setSeries))});function es(T,C,F){let U=b[C];F&&(T=T/Tt-(U.ori==1?ot:Je));let W=V;U.ori==1&&(W=Re,T=W-T),U.dir==-1&&(T=W-T);let ee=U._min,ue=U._max,me=T/W,Se=ee+(ue-ee)*me,De=U.distr;return De==3?co(10,Se):De==4?Ev(Se,U.asinh):De==100?U.bwd(Se):Se}function yx(T,C){let F=es(T,S,C);return Ui(F,e[0],sn,rn)}i.valToIdx=T=>Ui(T,e[0]),i.posToIdx=yx,i.posToVal=es,i.valToPos=(T,C,F)=>b[C].ori==0?r(T,b[C],F?$:V,F?O:0):o(T,b[C],F?de:Re,F?E:0),i.setCursor=(T,C,F)=>{Ht=T.left,Jt=T.top,pr(null,C,F)};function sp(T,C){qt(jr,oo,Wt.left=T),qt(jr,_a,Wt.width=C)}function rp(T,C){qt(jr,"top",Wt.top=T),qt(jr,xa,Wt.height=C)}let sa=L.ori==0?sp:rp,ra=L.ori==1?sp:rp;function bx(){if(j&&ie.live)for(let T=s==2?1:0;T<x.length;T++){if(T==0&&ct)continue;let C=ie.values[T],F=0;for(let U in C)He[T][F++].firstChild.nodeValue=C[U]}}function mh(T,C){if(T!=null&&(T.idxs?T.idxs.forEach((F,U)=>{q[U]=F}):Iv(T.idx)||q.fill(T.idx),ie.idx=q[0]),j&&ie.live){for(let F=0;F<x.length;F++)(F>0||s==1&&!ct)&&Sx(F,q[F]);bx()}ge=!1,C!==!1&&En("setLegend")}i.setLegend=mh;function Sx(T,C){let F=x[T],U=T==0&&N==2?ri:e[T],W;ct?W=F.values(i,T,C)??it:(W=F.value(i,C==null?null:U[C],T,C),W=W==null?it:{_:W}),ie.values[T]=W}function pr(T,C,F){np=Ht,ip=Jt,[Ht,Jt]=ne.move(i,Ht,Jt),ne.left=Ht,ne.top=Jt,he&&($r&&ss($r,vn(Ht),0,V,Re),Jr&&ss(Jr,0,vn(Jt),V,Re));let U,W=sn>rn;gs=Bt,Gs=null;let ee=L.ori==0?V:Re,ue=L.ori==1?V:Re;if(Ht<0||Qt==0||W){U=ne.idx=null;for(let me=0;me<x.length;me++){let Se=lt[me];Se!=null&&ss(Se,-10,-10,V,Re)}je&&Qi(null,Qr,!0,T==null&&hn.setSeries),ie.live&&(q.fill(U),ge=!0)}else{let me,Se,De;s==1&&(me=L.ori==0?Ht:Jt,Se=es(me,S),U=ne.idx=Ui(Se,e[0],sn,rn),De=B(e[0][U],L,ee,0));let Ne=-10,Ue=-10,st=0,wt=0,St=!0,mt="",Ze="";for(let Xe=s==2?1:0;Xe<x.length;Xe++){let Xt=x[Xe],tn=q[Xe],Cn=tn==null?null:s==1?e[Xe][tn]:e[Xe][1][tn],Nt=ne.dataIdx(i,Xe,U,Se),nn=Nt==null?null:s==1?e[Xe][Nt]:e[Xe][1][Nt];if(ge=ge||nn!=Cn||Nt!=tn,q[Xe]=Nt,Xe>0&&Xt.show){let oi=Nt==null?-10:Nt==U?De:B(s==1?e[0][Nt]:e[Xe][0][Nt],L,ee,0),qn=nn==null?-10:D(nn,s==1?b[Xt.scale]:b[Xt.facets[1].scale],ue,0);if(je&&nn!=null){let xi=L.ori==1?Ht:Jt,Di=yn(Be.dist(i,Xe,Nt,qn,xi));if(Di<gs){let ts=Be.bias;if(ts!=0){let ai=es(xi,Xt.scale),vi=nn>=0?1:-1,Ni=ai>=0?1:-1;Ni==vi&&(Ni==1?ts==1?nn>=ai:nn<=ai:ts==1?nn<=ai:nn>=ai)&&(gs=Di,Gs=Xe)}else gs=Di,Gs=Xe}}if(ge||Ce){let xi,Di;L.ori==0?(xi=oi,Di=qn):(xi=qn,Di=oi);let ts,ai,vi,Ni,ns,Yn,li=!0,mr=fe.bbox;if(mr!=null){li=!1;let $n=mr(i,Xe);vi=$n.left,Ni=$n.top,ts=$n.width,ai=$n.height}else vi=xi,Ni=Di,ts=ai=fe.size(i,Xe);if(Yn=fe.fill(i,Xe),ns=fe.stroke(i,Xe),Ce)Xe==Gs&&gs<=Be.prox&&(Ne=vi,Ue=Ni,st=ts,wt=ai,St=li,mt=Yn,Ze=ns);else{let $n=lt[Xe];$n!=null&&(Gt[Xe]=vi,Wn[Xe]=Ni,Am($n,ts,ai,li),wm($n,Yn,ns),ss($n,Ai(vi),Ai(Ni),V,Re))}}}}if(Ce){let Xe=Be.prox,Xt=dr==null?gs<=Xe:gs>Xe||Gs!=dr;if(ge||Xt){let tn=lt[0];tn!=null&&(Gt[0]=Ne,Wn[0]=Ue,Am(tn,st,wt,St),wm(tn,mt,Ze),ss(tn,Ai(Ne),Ai(Ue),V,Re))}}}if(Wt.show&&zs)if(T!=null){let[me,Se]=hn.scales,[De,Ne]=hn.match,[Ue,st]=T.cursor.sync.scales,wt=T.cursor.drag;if(Tn=wt._x,An=wt._y,Tn||An){let{left:St,top:mt,width:Ze,height:Xe}=T.select,Xt=T.scales[Ue].ori,tn=T.posToVal,Cn,Nt,nn,oi,qn,xi=me!=null&&De(me,Ue),Di=Se!=null&&Ne(Se,st);xi&&Tn?(Xt==0?(Cn=St,Nt=Ze):(Cn=mt,Nt=Xe),nn=b[me],oi=B(tn(Cn,Ue),nn,ee,0),qn=B(tn(Cn+Nt,Ue),nn,ee,0),sa(Bi(oi,qn),yn(qn-oi))):sa(0,ee),Di&&An?(Xt==1?(Cn=St,Nt=Ze):(Cn=mt,Nt=Xe),nn=b[Se],oi=D(tn(Cn,st),nn,ue,0),qn=D(tn(Cn+Nt,st),nn,ue,0),ra(Bi(oi,qn),yn(qn-oi))):ra(0,ue)}else xh()}else{let me=yn(np-ep),Se=yn(ip-tp);if(L.ori==1){let st=me;me=Se,Se=st}Tn=Fn.x&&me>=Fn.dist,An=Fn.y&&Se>=Fn.dist;let De=Fn.uni;De!=null?Tn&&An&&(Tn=me>=De,An=Se>=De,!Tn&&!An&&(Se>me?An=!0:Tn=!0)):Fn.x&&Fn.y&&(Tn||An)&&(Tn=An=!0);let Ne,Ue;Tn&&(L.ori==0?(Ne=Zr,Ue=Ht):(Ne=Kr,Ue=Jt),sa(Bi(Ne,Ue),yn(Ue-Ne)),An||ra(0,ue)),An&&(L.ori==1?(Ne=Zr,Ue=Ht):(Ne=Kr,Ue=Jt),ra(Bi(Ne,Ue),yn(Ue-Ne)),Tn||sa(0,ee)),!Tn&&!An&&(sa(0,0),ra(0,0))}if(Fn._x=Tn,Fn._y=An,T==null){if(F){if(gp!=null){let[me,Se]=hn.scales;hn.values[0]=me!=null?es(L.ori==0?Ht:Jt,me):null,hn.values[1]=Se!=null?es(L.ori==1?Ht:Jt,Se):null}aa(Vh,i,Ht,Jt,V,Re,U)}if(je){let me=F&&hn.setSeries,Se=Be.prox;dr==null?gs<=Se&&Qi(Gs,Qr,!0,me):gs>Se?Qi(null,Qr,!0,me):Gs!=dr&&Qi(Gs,Qr,!0,me)}}ge&&(ie.idx=U,mh()),C!==!1&&En("setCursor")}let Hs=null;Object.defineProperty(i,"rect",{get(){return Hs==null&&oa(!1),Hs}});function oa(T=!1){T?Hs=null:(Hs=_.getBoundingClientRect(),En("syncRect",Hs))}function op(T,C,F,U,W,ee,ue){ne._lock||zs&&T!=null&&T.movementX==0&&T.movementY==0||(gh(T,C,F,U,W,ee,ue,!1,T!=null),T!=null?pr(null,!0,!0):pr(C,!0,!1))}function gh(T,C,F,U,W,ee,ue,me,Se){if(Hs==null&&oa(!1),Ke(T),T!=null)F=T.clientX-Hs.left,U=T.clientY-Hs.top;else{if(F<0||U<0){Ht=-10,Jt=-10;return}let[De,Ne]=hn.scales,Ue=C.cursor.sync,[st,wt]=Ue.values,[St,mt]=Ue.scales,[Ze,Xe]=hn.match,Xt=C.axes[0].side%2==1,tn=L.ori==0?V:Re,Cn=L.ori==1?V:Re,Nt=Xt?ee:W,nn=Xt?W:ee,oi=Xt?U:F,qn=Xt?F:U;if(St!=null?F=Ze(De,St)?a(st,b[De],tn,0):-10:F=tn*(oi/Nt),mt!=null?U=Xe(Ne,mt)?a(wt,b[Ne],Cn,0):-10:U=Cn*(qn/nn),L.ori==1){let xi=F;F=U,U=xi}}Se&&(C==null||C.cursor.event.type==Vh)&&((F<=1||F>=V-1)&&(F=Sr(F,V)),(U<=1||U>=Re-1)&&(U=Sr(U,Re))),me?(ep=F,tp=U,[Zr,Kr]=ne.move(i,F,U)):(Ht=F,Jt=U)}let _h={width:0,height:0,left:0,top:0};function xh(){Sl(_h,!1)}let ap,lp,cp,up;function hp(T,C,F,U,W,ee,ue){zs=!0,Tn=An=Fn._x=Fn._y=!1,gh(T,C,F,U,W,ee,ue,!0,!1),T!=null&&(bt(Gh,Yh,fp,!1),aa(_m,i,Zr,Kr,V,Re,null));let{left:me,top:Se,width:De,height:Ne}=Wt;ap=me,lp=Se,cp=De,up=Ne}function fp(T,C,F,U,W,ee,ue){zs=Fn._x=Fn._y=!1,gh(T,C,F,U,W,ee,ue,!1,!0);let{left:me,top:Se,width:De,height:Ne}=Wt,Ue=De>0||Ne>0,st=ap!=me||lp!=Se||cp!=De||up!=Ne;if(Ue&&st&&Sl(Wt),Fn.setScale&&Ue&&st){let wt=me,St=De,mt=Se,Ze=Ne;if(L.ori==1&&(wt=Se,St=Ne,mt=me,Ze=De),Tn&&Vs(S,es(wt,S),es(wt+St,S)),An)for(let Xe in b){let Xt=b[Xe];Xe!=S&&Xt.from==null&&Xt.min!=Bt&&Vs(Xe,es(mt+Ze,Xe),es(mt,Xe))}xh()}else ne.lock&&(ne._lock=!ne._lock,pr(C,!0,T!=null));T!=null&&(mn(Gh,Yh),aa(Gh,i,Ht,Jt,V,Re,null))}function Mx(T,C,F,U,W,ee,ue){if(ne._lock)return;Ke(T);let me=zs;if(zs){let Se=!0,De=!0,Ne=10,Ue,st;L.ori==0?(Ue=Tn,st=An):(Ue=An,st=Tn),Ue&&st&&(Se=Ht<=Ne||Ht>=V-Ne,De=Jt<=Ne||Jt>=Re-Ne),Ue&&Se&&(Ht=Ht<Zr?0:V),st&&De&&(Jt=Jt<Kr?0:Re),pr(null,!0,!0),zs=!1}Ht=-10,Jt=-10,q.fill(null),pr(null,!0,!0),me&&(zs=me)}function dp(T,C,F,U,W,ee,ue){ne._lock||(Ke(T),ia(),xh(),T!=null&&aa(ym,i,Ht,Jt,V,Re,null))}function pp(){M.forEach(Yy),z(i.width,i.height,!0)}Tr(Wl,lo,pp);let eo={};eo.mousedown=hp,eo.mousemove=op,eo.mouseup=fp,eo.dblclick=dp,eo.setSeries=(T,C,F,U)=>{let W=hn.match[2];F=W(i,C,F),F!=-1&&Qi(F,U,!0,!1)},he&&(bt(_m,_,hp),bt(Vh,_,op),bt(xm,_,T=>{Ke(T),oa(!1)}),bt(vm,_,Mx),bt(ym,_,dp),tf.add(i),i.syncRect=oa);let Ml=i.hooks=n.hooks||{};function En(T,C,F){Xn?It.push([T,C,F]):T in Ml&&Ml[T].forEach(U=>{U.call(null,i,C,F)})}(n.plugins||[]).forEach(T=>{for(let C in T.hooks)Ml[C]=(Ml[C]||[]).concat(T.hooks[C])});let mp=(T,C,F)=>F,hn=dn({key:null,setSeries:!1,filters:{pub:Im,sub:Im},scales:[S,x[1]?x[1].scale:null],match:[Lm,Lm,mp],values:[null,null]},ne.sync);hn.match.length==2&&hn.match.push(mp),ne.sync=hn;let gp=hn.key,vh=Cg(gp);function aa(T,C,F,U,W,ee,ue){hn.filters.pub(T,C,F,U,W,ee,ue)&&vh.pub(T,C,F,U,W,ee,ue)}vh.sub(i);function wx(T,C,F,U,W,ee,ue){hn.filters.sub(T,C,F,U,W,ee,ue)&&eo[T](null,C,F,U,W,ee,ue)}i.pub=wx;function Tx(){vh.unsub(i),tf.delete(i),wn.clear(),Zh(Wl,lo,pp),c.remove(),_e?.remove(),En("destroy")}i.destroy=Tx;function yh(){En("init",n,e),na(e||n.data,!1),G[S]?fh(S,G[S]):ia(),ae=Wt.show&&(Wt.width>0||Wt.height>0),re=ge=!0,z(n.width,n.height)}return x.forEach(Wr),M.forEach(fs),t?t instanceof HTMLElement?(t.appendChild(c),yh()):t(i,yh):yh(),i}In.assign=dn;In.fmtNum=cf;In.rangeNum=Xl;In.rangeLog=$l;In.rangeAsinh=af;In.orient=Er;In.pxRatio=Tt;In.join=Bv;In.fmtDate=hf,In.tzDate=Jv;In.sync=Cg;{In.addGap=Iy,In.clipGaps=Kl;let n=In.paths={points:Ng};n.linear=Fg,n.stepped=Ny,n.bars=Oy,n.spline=Uy}var $y=Symbol.for("pv"),Jy=0;function A(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:$y,__v:--Jy,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Lt.vnode&&Lt.vnode(c),c}var ki=({tone:n,children:e})=>A("span",{class:`badge ${n}`,children:e}),Zy={queued:"wait",running:"wait",succeeded:"good",failed:"bad",dead:"bad",expired:"bad",cancelled:"neutral"},_o=({state:n})=>A(ki,{tone:Zy[n],children:n}),Cr=({share:n,label:e})=>A("progress",{class:"bar",max:1,value:n,"aria-label":e});function Ln({text:n}){return n===null?null:A("p",{class:"failure",role:"alert",children:n})}function ei({rows:n}){return A("dl",{class:"facts",children:n.map(([e,t])=>A("div",{children:[A("dt",{children:e}),A("dd",{children:t})]},e))})}function Js(){let[n,e]=Oe(Date.now());return Ft(()=>{let t=setInterval(()=>e(Date.now()),1e3);return()=>clearInterval(t)},[]),n}function Ei(n,e){Ft(()=>{let t=new AbortController;return n(t.signal),()=>t.abort()},e)}function Ma(){let[n,e]=Oe(0);return Ft(()=>{let t=()=>e(s=>s+1),i=matchMedia("(prefers-color-scheme: dark)");return i.addEventListener("change",t),window.addEventListener("theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("theme",t)}},[]),n}function xo(n){let e=Jn(null),t=Jn(null),i=Jn(n.marks);i.current=n.marks;let s=Ma(),r=JSON.stringify([s,n.log,n.series.map(({label:a,color:l,scale:c})=>[a,l,c]),n.height]),o=[n.x,...n.series.map(a=>a.values)];return Ft(()=>{let a=e.current,{color:l,borderTopColor:c}=getComputedStyle(a),u={stroke:l,grid:{stroke:c,width:1},ticks:{stroke:c,width:1},font:"12px system-ui",labelFont:"12px system-ui",labelSize:18},h=n.series.some(_=>_.scale==="right"),f=new In({width:a.clientWidth||300,height:n.height,scales:{x:{time:!1},y:{distr:n.log?3:1},right:{}},axes:[{...u,label:n.xLabel},{...u,label:n.yLabel,size:58},...h?[{...u,label:n.rightLabel,scale:"right",side:1,size:50,grid:{show:!1}}]:[]],series:[{label:n.xLabel},...n.series.map(({label:_,color:v,dash:p,width:g,scale:x,points:M})=>({label:_,stroke:v,width:g??1.5,dash:p,scale:x??"y",spanGaps:!0,points:{show:M??!1,size:5},fill:n.bars?v:void 0,paths:n.bars?In.paths.bars({size:[.9]}):M?()=>null:void 0,value:(b,y)=>y==null?"–":y.toPrecision(4)}))],legend:{live:!n.bars},hooks:{draw:[_=>{let{ctx:v}=_;v.save(),v.strokeStyle=c,v.fillStyle=l,v.font=`${12*devicePixelRatio}px system-ui`;for(let{at:p,text:g}of i.current??[]){let x=_.valToPos(p,"x",!0);v.beginPath(),v.moveTo(x,_.bbox.top),v.lineTo(x,_.bbox.top+_.bbox.height),v.stroke(),v.fillText(g,x+4*devicePixelRatio,_.bbox.top+12*devicePixelRatio)}v.restore()}]}},o,a);t.current=f;let d=new ResizeObserver(()=>f.setSize({width:a.clientWidth,height:n.height}));return d.observe(a),()=>{d.disconnect(),f.destroy()}},[r]),Ft(()=>t.current?.setData(o)),A("div",{class:"plot",ref:e,role:"img","aria-label":n.title,"data-points":n.x.length})}function tc({value:n,take:e,...t}){let[i,s]=Oe(null);return A("input",{...t,value:i??n,onInput:r=>s(r.currentTarget.value),onChange:r=>{s(null),e(r.currentTarget.value)}})}function Rr({label:n,checked:e,onChange:t}){return A("label",{class:"check",children:[A("input",{type:"checkbox",checked:e,onChange:t})," ",n]})}function zg(){let[n="",e=""]=location.hash.replace(/^#\/?/,"").split("?");return{path:n.split("/").filter(Boolean).map(decodeURIComponent),query:new URLSearchParams(e)}}function Zs(n,e={},t=!1){let i=Object.entries(e).filter(([,o])=>o!==""),s=new URLSearchParams(i).toString(),r=`#/${n}${s===""?"":`?${s}`}`;t?(history.replaceState(null,"",r),window.dispatchEvent(new HashChangeEvent("hashchange"))):location.hash=r}function Vg(){let[n,e]=Oe(zg);return Ft(()=>{let t=()=>e(zg());return window.addEventListener("hashchange",t),()=>window.removeEventListener("hashchange",t)},[]),n}var nc=n=>{let{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,external_ref:d,cancel_requested:_,labels:v}=n;return{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,external_ref:d,cancel_requested:_,labels:v}},[Gg,Ky]=[100,500],[jy,xf]=[300,2e3],vf=20,Qy=44,Hg=["state","method","label","external_ref","batch","order"];function Wg({query:n}){let e=Object.fromEntries(Hg.map(y=>[y,n.get(y)??""])),t=JSON.stringify(e),[i,s]=Oe([]),[r,o]=Oe(""),[a,l]=Oe(null),[c,u]=Oe(!0),[h,f]=Oe([]),[d,_]=Oe(!1),v=y=>l(Rn(y)),p=Jn(new Map);p.current=yi(()=>new Map(i.map(y=>[y.id,y])),[i]);let g=Jn(null);Ei(y=>{s([]),o(""),_(!1);let S=new Set,m=async(q,ie)=>{let ne=new Set;S.add(ne);try{let j=await q();y.aborted||ie(j,ne)}finally{S.delete(ne)}},w=(q,ie,ne)=>m(()=>Ut(`v1/jobs${qs({...e,page_size:q,page_token:ie})}`,y),(j,he)=>{ne(j,j.jobs.map(nc),he),k(j.jobs.map(({id:pe})=>pe).filter(pe=>he.has(pe)))}),I=()=>w(Gg,"",(q,ie)=>{s(ne=>{let j=new Map(ne.map(he=>[he.id,he]));return ie.map(he=>yr(j.get(he.id),he))}),o(q.next_page_token),l(null)}),P=!1,L=async q=>{if(!P){P=!0;try{await w(Ky,q,(ie,ne)=>{s(j=>[...j,...ne]),o(ie.next_page_token),l(null)})}catch(ie){y.aborted||v(ie)}finally{P=!1}}},N=async()=>{let q=new Set;return e.order==="asc"||await w(Gg,"",(ie,ne,j)=>{q=new Set(ne.map(he=>he.id)),s(he=>{let pe=new Map(he.map(_e=>[_e.id,_e]));return[...ne.map(_e=>j.has(_e.id)&&pe.get(_e.id)||yr(pe.get(_e.id),_e)),...he.filter(_e=>!q.has(_e.id))]})}),q},B=q=>e.state===""||e.state.split(",").includes(q.state),D=async q=>{for(let ie=0;ie<q.length&&!y.aborted;ie+=vf){let ne=[],j=he=>Ut(`v1/jobs/${he}`,y).then(nc,pe=>(ro(pe)||ne.push(he),null));await m(()=>Promise.all(q.slice(ie,ie+vf).map(j)),(he,pe)=>{let _e=new Map(he.flatMap(xe=>xe===null||pe.has(xe.id)?[]:[[xe.id,xe]]));s(xe=>xe.map(Ge=>yr(Ge,_e.get(Ge.id)??Ge)).filter(B))}),k(ne,xf)}},G=new Set,J=0,k=(q,ie=jy)=>{q.forEach(ne=>G.add(ne)),G.size>0&&J===0&&!y.aborted&&(J=window.setTimeout(()=>{Y()},ie))},se=!1,Y=async()=>{J=0;let q=[...G];G.clear();let ie=q.filter(j=>p.current.has(j)),ne=ie.length>vf;if(ne&&se)return k(q,xf);se||=ne;try{let j=ne||ie.length<q.length?await N():new Set;await D(ie.filter(he=>!j.has(he)))}catch(j){ro(j)||k(q,xf)}finally{ne&&(se=!1)}};g.current={more:L,renew:D};let K=I().catch(q=>{y.aborted||v(q)});dm(async()=>{await K;try{await I(),_(!0)}catch(q){if(!ro(q))throw q;v(q)}},q=>{let ie=q.map(({job_id:ne})=>ne);for(let ne of S)ie.forEach(j=>ne.add(j));k(ie)},u,y),(async()=>{for(;!y.aborted;){await wi(2e3,y);let q=[...p.current.values()].filter(ie=>ie.state==="running").slice(0,16);q.length>0&&!document.hidden&&await D(q.map(ie=>ie.id))}})()},[t]),Ft(()=>{Ut("v1/methods").then(({methods:y})=>f(y.map(({name:S})=>S)),()=>{})},[]);let x=(y,S)=>Zs("jobs",{...e,[y]:S},!0),M=()=>{let{order:y,...S}=e,m=Object.values(S).some(w=>w!=="");confirm(m?"Cancel all queued and running jobs that these filters select?":"Cancel all queued and running jobs?")&&is("POST",`v1/jobs/cancel${qs({...S,all:m?void 0:"true"})}`).catch(v)},b=Hg.some(y=>e[y]!=="");return A("div",{class:"jobs",children:[A("h1",{children:["Jobs ",!c&&A(ki,{tone:"bad",children:"connection lost, trying again"})]}),A("form",{class:"tools",role:"search","aria-label":"Filters",onSubmit:y=>y.preventDefault(),children:[A("label",{children:["State"," ",A("select",{value:e.state,onChange:y=>x("state",y.currentTarget.value),children:[A("option",{value:"",children:"any"}),Nl.map(y=>A("option",{value:y,children:y}))]})]}),A("label",{children:["Method"," ",A("select",{value:e.method,onChange:y=>x("method",y.currentTarget.value),children:[A("option",{value:"",children:"any"}),h.map(y=>A("option",{value:y,children:y}))]})]}),A("label",{children:["Label ",A(tc,{value:e.label,placeholder:"name:value",take:y=>x("label",y)})]}),A("label",{children:["Reference ",A(tc,{value:e.external_ref,take:y=>x("external_ref",y)})]}),A("label",{children:["Order"," ",A("select",{value:e.order,onChange:y=>x("order",y.currentTarget.value),children:[A("option",{value:"",children:"newest first"}),A("option",{value:"asc",children:"oldest first"})]})]}),b&&A("button",{type:"button",onClick:()=>Zs("jobs",{},!0),children:"Clear filters"}),A("button",{type:"button",onClick:M,children:"Cancel these …"})]}),A(Ln,{text:a}),A(tb,{rows:i,hasMore:r!==void 0,more:d&&r?()=>{g.current?.more(r)}:null,renew:y=>{g.current?.renew(y)},failed:v}),i.length===0&&r===void 0&&A("p",{class:"empty",children:[b?"No job fits these filters.":"There is no job yet."," ",A("a",{href:"#/submit",children:"Submit a pair of surfaces"}),", or the two built-in phantoms."]})]})}function eb(n,e){let[,t]=Oe(0),i=Jn(null),s={count:n,getScrollElement:()=>e.current,estimateSize:()=>Qy,overscan:8,scrollToFn:om,observeElementRect:sm,observeElementOffset:rm,onChange:()=>t(r=>r+1)};return i.current??=new Bl(s),i.current.setOptions(s),Ft(()=>i.current._didMount(),[]),Ft(()=>i.current._willUpdate()),i.current}function tb({rows:n,hasMore:e,more:t,renew:i,failed:s}){let r=Jn(null),o=eb(n.length,r),a=Js(),l=o.getVirtualItems(),c=l.at(-1)?.index??0;Ft(()=>{c>=n.length-12&&t?.()},[t===null,c,n.length]);let u=(v,p)=>{is("POST",`v1/jobs/${p}/${v}`).then(g=>v==="retry"?Zs(`jobs/${g.id}`):i([p]),s)},h=(v,p)=>is("PATCH",`v1/jobs/${v}`,{priority:p}).then(()=>i([v]),s),f=v=>{let p={ArrowDown:1,j:1,ArrowUp:-1,k:-1,PageDown:12,PageUp:-12}[v.key],g=v.target;if(p===void 0||g.tagName==="INPUT")return;let x=Number(g.closest("tr")?.dataset.index??-1),M=Math.min(n.length-1,Math.max(0,x+p));v.preventDefault(),o.scrollToIndex(M);let b=y=>{let S=r.current?.querySelector(`tr[data-index="${M}"] a`);S?S.focus():y>0&&requestAnimationFrame(()=>b(y-1))};requestAnimationFrame(()=>b(10))},d=l[0]?.start??0,_=Math.max(0,o.getTotalSize()-(l.at(-1)?.end??0));return A("div",{class:"rows",ref:r,onKeyDown:f,tabIndex:0,role:"region","aria-label":"Jobs; arrow keys move from row to row, Enter opens one",children:A("table",{"aria-rowcount":e?-1:n.length+1,children:[A("thead",{children:A("tr",{children:[A("th",{scope:"col",children:"Job"}),A("th",{scope:"col",children:"State"}),A("th",{scope:"col",children:"Verdict"}),A("th",{scope:"col",class:"numeric",children:"Distance"}),A("th",{scope:"col",children:"Energy"}),A("th",{scope:"col",children:"Method"}),A("th",{scope:"col",children:"Age"}),A("th",{scope:"col",children:"Ran for"}),A("th",{scope:"col",children:"Priority"}),A("th",{scope:"col",children:A("span",{class:"quiet",children:"Actions"})})]})}),A("tbody",{children:[d>0&&A("tr",{"aria-hidden":"true",style:{height:`${d}px`}}),l.map(({index:v})=>{let p=n[v];if(p===void 0)return null;let g=Fl(p);return A("tr",{"data-index":v,"data-state":p.state,"aria-rowindex":v+2,children:[A("td",{children:[A("a",{href:`#/jobs/${p.id}`,title:p.id,children:A("code",{children:["…",Mi(p.id)]})})," ",p.external_ref&&A("span",{class:"soft",children:p.external_ref}),p.batch_id&&A("a",{class:"soft",href:`#/batches/${p.batch_id}`,children:"batch"})]}),A("td",{children:[A(_o,{state:p.state}),p.state==="running"&&A(Cr,{share:p.progress?.fraction??0,label:`Progress: ${Pn(p.progress?.phase??"running")}`})]}),A("td",{children:g.text!==""&&A(ki,{tone:g.tone,children:g.text})}),A("td",{class:"numeric",children:p.surface_distance?ci(p.surface_distance.mean_mm):""}),A("td",{children:A(ib,{id:p.id,state:p.state})}),A("td",{children:p.method}),A("td",{children:io(p.created_at,a)}),A("td",{children:p.started_at?Si((p.finished_at?Date.parse(p.finished_at):a)-Date.parse(p.started_at)):""}),A("td",{children:p.state==="queued"?A(tc,{class:"priority",type:"number",min:-100,max:100,value:String(p.priority),"aria-label":`Priority of job ${Mi(p.id)}, −100 to 100, higher first`,take:x=>{h(p.id,Number(x))}}):p.priority}),A("td",{children:Zn(p.state)?A("button",{"aria-label":`Retry job ${Mi(p.id)}`,onClick:()=>u("retry",p.id),children:"Retry"}):A("button",{"aria-label":`Cancel job ${Mi(p.id)}`,disabled:p.cancel_requested,onClick:()=>u("cancel",p.id),children:"Cancel"})})]},p.id)}),_>0&&A("tr",{"aria-hidden":"true",style:{height:`${_}px`}})]})]})})}var wa=new Map,nb=2e3;function ib({id:n,state:e}){let[t,i]=Oe(wa.get(n)??[]);if(Ei(l=>{let c=wa.get(n);i(c??[]),!(e==="queued"||c!==void 0&&Zn(e))&&wi(250,l).then(async()=>{if(l.aborted)return;let u=await Ut(`v1/jobs/${n}/trace?limit=200`,l).catch(()=>null);if(u===null)return;let h=u.points.filter(ha),d=(h.length>0?h:u.points.filter(({phase:_})=>_==="inference")).flatMap(({energy:_})=>_===void 0?[]:[_]);wa.size>nb&&wa.clear(),Zn(e)&&wa.set(n,d),i(d)})},[n,e]),t.length<2)return null;let s=t.map(l=>Math.log(Math.max(l,1e-9))),[r,o]=[Math.min(...s),Math.max(...s)],a=s.map((l,c)=>`${(c/(s.length-1)*78+1).toFixed(1)},${(21-20*(l-r)/(o-r||1)).toFixed(1)}`);return A("svg",{class:"spark",width:"80",height:"22",role:"img","aria-label":`Energy from ${t[0].toPrecision(3)} to ${t.at(-1).toPrecision(3)}`,children:A("polyline",{points:a.join(" ")})})}function qg({batch:n}){let e=Math.max(1,n.n_jobs),t=Nl.flatMap(i=>n.counts[i]?[{state:i,n:n.counts[i]}]:[]);return A(_n,{children:[A("svg",{class:"counts",viewBox:"0 0 100 6",preserveAspectRatio:"none","aria-hidden":"true",children:t.map(({state:i,n:s},r)=>{let o=t.slice(0,r).reduce((a,l)=>a+l.n,0);return A("rect",{class:i,x:100*o/e,width:100*s/e,height:"6"})})}),A("span",{class:"soft",children:t.map(({state:i,n:s})=>`${s.toLocaleString("en")} ${i}`).join(", ")})]})}function Yg(){let[n,e]=Oe([]),[t,i]=Oe(),[s,r]=Oe(null),[o,a]=Oe(!1),l=Js(),c=async(u,h)=>{try{let f=await Ut(`v1/batches${qs({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.batches:[...d,...f.batches]),i(f.next_page_token),a(!0)}catch(f){h?.aborted||r(Rn(f))}};return Ei(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await wi(5e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),A("div",{children:[A("h1",{children:"Batches"}),A(Ln,{text:s}),o&&n.length===0&&A("p",{class:"empty",children:["There is no batch yet. ",A("code",{children:"POST /v1/batches"})," submits one template against many subjects at once; ",A("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&A("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Batches",children:A("table",{children:[A("thead",{children:A("tr",{children:[A("th",{scope:"col",children:"Batch"}),A("th",{scope:"col",class:"numeric",children:"Jobs"}),A("th",{scope:"col",children:"States"}),A("th",{scope:"col",children:"Labels"}),A("th",{scope:"col",children:"Age"})]})}),A("tbody",{children:n.map(u=>A("tr",{children:[A("td",{children:A("a",{href:`#/batches/${u.id}`,children:u.external_ref??`…${Mi(u.id)}`})}),A("td",{class:"numeric",children:$e(u.n_jobs)}),A("td",{children:A(qg,{batch:u})}),A("td",{children:Object.entries(u.labels).map(([h,f])=>`${h}:${f}`).join(", ")}),A("td",{children:io(u.created_at,l)})]},u.id))})]})}),t!==void 0&&A("button",{onClick:()=>{c(t)},children:"More"})]})}var ic=[{name:"Mean distance, mm",of:n=>n.surface_distance?.mean_mm},{name:"95 % within, mm",of:n=>n.surface_distance?.p95_mm},{name:"Largest distance, mm",of:n=>n.surface_distance?.max_mm}];function Xg(n){return Zn(n.state)?n.state!=="succeeded"?2e9:(n.reliable===!1?1e9:0)+(n.surface_distance?.p95_mm??0):-1}function $g({id:n}){let[e,t]=Oe(null),[i,s]=Oe([]),[r,o]=Oe(null),[a,l]=Oe(0);if(Ei(v=>{(async()=>{try{let p="";for(;!v.aborted;){let g=await Ut(`v1/batches/${n}${p}`,v);t(g);let x=[],M="";for(;M!==void 0;){let b=await Ut(`v1/batches/${n}/jobs${qs({page_size:500,page_token:M})}`,v);x.push(...b.jobs.map(nc)),M=b.next_page_token}if(s(x),g.finished)return;p="?wait=20",await wi(500,v)}}catch(p){v.aborted||o(Rn(p))}})()},[n]),e===null)return r===null?A("p",{class:"loading",children:"Loading the batch …"}):A(Ln,{text:r});let c=ic[a-1],u=[...i].sort((v,p)=>c?(c.of(p)??-1)-(c.of(v)??-1):Xg(p)-Xg(v)),h=i.filter(v=>v.state==="succeeded"),f=h.filter(v=>v.reliable===!1).length,d=i.filter(v=>Zn(v.state)&&v.state!=="succeeded").length,_=d+f>0?"bad":e.finished?"good":"wait";return A("article",{children:[A("h1",{class:"sub",children:["Batch ",e.external_ref??A("code",{children:n})]}),A("section",{class:`verdict ${_}`,"aria-label":"Verdict",children:[A("span",{class:"mark","aria-hidden":"true",children:_==="good"?"✓":_==="bad"?"✕":"…"}),A("div",{children:[A("p",{class:"title",children:d+f>0?`${d+f} of ${$e(e.n_jobs)} need a look`:e.finished?"All reliable, or not checked":"Running"}),A("p",{children:[f," not reliable, ",d," without a result, ",h.length-f," others succeeded."]}),A(qg,{batch:e})]}),A("div",{class:"actions",children:!e.finished&&A("button",{onClick:()=>is("POST",`v1/batches/${n}/cancel`).catch(v=>o(Rn(v))),children:"Cancel the rest"})})]}),A(Ln,{text:r}),A("div",{class:"columns three",children:ic.map(({name:v,of:p})=>A(sb,{name:v,values:h.flatMap(g=>p(g)??[])},v))}),A("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:A("table",{children:[A("thead",{children:A("tr",{children:[A("th",{scope:"col",children:"Subject"}),A("th",{scope:"col",children:"State"}),A("th",{scope:"col","aria-sort":a===0?"descending":void 0,children:A("button",{class:"plain",onClick:()=>l(0),children:"Verdict, worst first"})}),ic.map(({name:v},p)=>A("th",{scope:"col",class:"numeric","aria-sort":a===p+1?"descending":void 0,children:A("button",{class:"plain",onClick:()=>l(p+1),children:v})},v)),A("th",{scope:"col",children:"Ran for"})]})}),A("tbody",{children:u.slice(0,500).map(v=>{let p=Fl(v);return A("tr",{children:[A("td",{children:A("a",{href:`#/jobs/${v.id}`,children:v.external_ref??`…${Mi(v.id)}`})}),A("td",{children:A(_o,{state:v.state})}),A("td",{children:p.text!==""&&A(ki,{tone:p.tone,children:p.text})}),ic.map(({name:g,of:x})=>A("td",{class:"numeric",children:ci(x(v))},g)),A("td",{children:v.started_at&&v.finished_at?Si(Date.parse(v.finished_at)-Date.parse(v.started_at)):""})]},v.id)})})]})}),u.length>500&&A("p",{children:["The first 500 of ",$e(u.length),". ",A("a",{href:`#/jobs?batch=${n}`,children:"All of them"})]})]})}var sc=16;function sb({name:n,values:e}){if(e.length===0)return null;let t=Math.max(...e)*1.0001||1,i=Array.from({length:sc},()=>0);for(let o of e)i[Math.min(sc-1,Math.floor(sc*o/t))]++;let s=i.map((o,a)=>(a+.5)*t/sc),r=[...e].sort((o,a)=>o-a)[Math.floor(e.length/2)];return A("section",{class:"card",children:[A("h2",{children:n}),A(xo,{title:`${n}: ${e.length} matches, median ${r.toPrecision(3)}`,x:s,series:[{label:"matches",color:"#2f7ebc",values:i}],height:170,xLabel:n,yLabel:"matches",bars:!0,marks:[{at:r,text:`median ${r.toPrecision(3)}`}]})]})}var lr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2};var C0=0,Kf=1,R0=2;var ol=1,P0=2,Xo=3,cr=0,Qn=1,ii=2,kr=0,qo=1,jf=2,Qf=3,ed=4,I0=5;var zr=100,L0=101,D0=102,N0=103,O0=104,F0=200,U0=201,B0=202,k0=203,td=204,nd=205,z0=206,V0=207,G0=208,H0=209,W0=210,X0=211,q0=212,Y0=213,$0=214,Pc=0,Ic=1,Lc=2,No=3,Dc=4,Nc=5,Oc=6,Fc=7,au=0,J0=1,Z0=2,cs=0,id=1,sd=2,rd=3,od=4,ad=5,ld=6,cd=7;var ud=300,Vr=301,Yo=302,lu=303,cu=304,Uc=1e3,os=1001,Bc=1002,Nn=1003,K0=1004;var al=1005;var jn=1006,uu=1007;var Ns=1008;var si=1009,hd=1010,fd=1011,$o=1012,hu=1013,Xi=1014,Ii=1015,qi=1016,fu=1017,du=1018,Gr=1020,dd=35902,pd=35899,md=1021,gd=1022,Yi=1023,Es=1026,Os=1027,pu=1028,mu=1029,ur=1030,gu=1031;var _u=1033,ll=33776,cl=33777,ul=33778,hl=33779,xu=35840,vu=35841,yu=35842,bu=35843,Su=36196,Mu=37492,wu=37496,Tu=37488,Au=37489,fl=37490,Eu=37491,Cu=37808,Ru=37809,Pu=37810,Iu=37811,Lu=37812,Du=37813,Nu=37814,Ou=37815,Fu=37816,Uu=37817,Bu=37818,ku=37819,zu=37820,Vu=37821,Gu=36492,Hu=36494,Wu=36495,Xu=36283,qu=36284,dl=36285,Yu=36286;var Oa=2300,kc=2301,Cc=2302,Vf=2303,Gf=2400,Hf=2401,Wf=2402;var j0=3200;var $u=0,Q0=1,Fs="",Gn="srgb",Fa="srgb-linear",Ua="linear",Ct="srgb";var Rc=7680;var e_=519,t_=512,n_=513,i_=514,_d=515,s_=516,r_=517,xd=518,vd=519,o_=35044;var yd="300 es",Ri=2e3,Oo=2001;function rb(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function ob(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ba(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function a_(){let n=Ba("canvas");return n.style.display="block",n}var Jg={},Fo=null;function bd(...n){let e="THREE."+n.shift();Fo?Fo("log",e,...n):console.log(e,...n)}function l_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=l_(n);let e="THREE."+n.shift();if(Fo)Fo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=l_(n);let e="THREE."+n.shift();if(Fo)Fo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function La(...n){let e=n.join(" ");e in Jg||(Jg[e]=!0,Ye(...n))}function c_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var u_={[Pc]:Pc,[Lc]:Oc,[Dc]:Dc,[No]:Nc,[Ic]:Ic,[Oc]:Lc,[Fc]:Fc,[Nc]:No},Wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Zg=1234567,Da=Math.PI/180,Uo=180/Math.PI;function Jo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]+"-"+zn[e&255]+zn[e>>8&255]+"-"+zn[e>>16&15|64]+zn[e>>24&255]+"-"+zn[t&63|128]+zn[t>>8&255]+"-"+zn[t>>16&255]+zn[t>>24&255]+zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]).toLowerCase()}function yt(n,e,t){return Math.max(e,Math.min(t,n))}function Sd(n,e){return(n%e+e)%e}function ab(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function lb(n,e,t){return n!==e?(t-n)/(e-n):0}function Na(n,e,t){return(1-t)*n+t*e}function cb(n,e,t,i){return Na(n,e,1-Math.exp(-t*i))}function ub(n,e=1){return e-Math.abs(Sd(n,e*2)-e)}function hb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function fb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function db(n,e){return n+Math.floor(Math.random()*(e-n+1))}function pb(n,e){return n+Math.random()*(e-n)}function mb(n){return n*(.5-Math.random())}function gb(n){n!==void 0&&(Zg=n);let e=Zg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function _b(n){return n*Da}function xb(n){return n*Uo}function vb(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function yb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Md(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function bb(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),_=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*d,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function wd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function h_(n,e){if(e.constructor===Float32Array)return n;let t=wd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function f_(n,e){if(e.constructor===Float32Array)return n;let t=wd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ju={DEG2RAD:Da,RAD2DEG:Uo,generateUUID:Jo,clamp:yt,euclideanModulo:Sd,mapLinear:ab,inverseLerp:lb,lerp:Na,damp:cb,pingpong:ub,smoothstep:hb,smootherstep:fb,randInt:db,randFloat:pb,randFloatSpread:mb,seededRandom:gb,degToRad:_b,radToDeg:xb,isPowerOfTwo:vb,ceilPowerOfTwo:yb,floorPowerOfTwo:Md,setQuaternionFromProperEuler:bb,normalize:f_,denormalize:h_},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Un=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],_=r[o+2],v=r[o+3];if(h!==v||l!==f||c!==d||u!==_){let p=l*f+c*d+u*_+h*v;p<0&&(f=-f,d=-d,_=-_,v=-v,p=-p);let g=1-a;if(p<.9995){let x=Math.acos(p),M=Math.sin(x);g=Math.sin(g*x)/M,a=Math.sin(a*x)/M,l=l*g+f*a,c=c*g+d*a,u=u*g+_*a,h=h*g+v*a}else{l=l*g+f*a,c=c*g+d*a,u=u*g+_*a,h=h*g+v*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*d-c*f,e[t+1]=l*_+u*f+c*h-a*d,e[t+2]=c*_+u*d+a*f-l*h,e[t+3]=u*_-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"YXZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"ZXY":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"ZYX":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"YZX":this._x=f*u*h+c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h-f*d*_;break;case"XZY":this._x=f*u*h-c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h+f*d*_;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Kg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Kg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return yf.copy(this).projectOnVector(e),this.sub(yf)}reflect(e){return this.sub(yf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yf=new X,Kg=new Un,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],_=i[8],v=s[0],p=s[3],g=s[6],x=s[1],M=s[4],b=s[7],y=s[2],S=s[5],m=s[8];return r[0]=o*v+a*x+l*y,r[3]=o*p+a*M+l*S,r[6]=o*g+a*b+l*m,r[1]=c*v+u*x+h*y,r[4]=c*p+u*M+h*S,r[7]=c*g+u*b+h*m,r[2]=f*v+d*x+_*y,r[5]=f*p+d*M+_*S,r[8]=f*g+d*b+_*m,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,_=t*h+i*f+s*d;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return La("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(bf.makeScale(e,t)),this}rotate(e){return La("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(bf.makeRotation(-e)),this}translate(e,t){return La("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(bf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},bf=new nt,jg=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qg=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Sb(){let n={enabled:!0,workingColorSpace:Fa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=As(s.r),s.g=As(s.g),s.b=As(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Do(s.r),s.g=Do(s.g),s.b=Do(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fs?Ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Fa]:{primaries:e,whitePoint:i,transfer:Ua,toXYZ:jg,fromXYZ:Qg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:e,whitePoint:i,transfer:Ct,toXYZ:jg,fromXYZ:Qg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}}),n}var vt=Sb();function As(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Do(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var vo,zc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{vo===void 0&&(vo=Ba("canvas")),vo.width=e.width,vo.height=e.height;let s=vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=vo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ba("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=As(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(As(t[i]/255)*255):t[i]=As(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Mb=0,Bo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Mb++}),this.uuid=Jo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Sf(s[o].image)):r.push(Sf(s[o]))}else r=Sf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Sf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?zc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var wb=0,Mf=new X,ti=class n extends Wi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=os,s=os,r=jn,o=Ns,a=Yi,l=si,c=n.DEFAULT_ANISOTROPY,u=Fs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:wb++}),this.uuid=Jo(),this.name="",this.source=new Bo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Mf).x}get height(){return this.source.getSize(Mf).y}get depth(){return this.source.getSize(Mf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ud)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Uc:e.x=e.x-Math.floor(e.x);break;case os:e.x=e.x<0?0:1;break;case Bc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Uc:e.y=e.y-Math.floor(e.y);break;case os:e.y=e.y<0?0:1;break;case Bc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=ud;ti.DEFAULT_ANISOTROPY=1;var zt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],_=l[9],v=l[2],p=l[6],g=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(_-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(_+p)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(d+1)/2,y=(g+1)/2,S=(u+f)/4,m=(h+v)/4,w=(_+p)/4;return M>b&&M>y?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=S/i,r=m/i):b>y?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=S/s,r=w/s):y<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(y),i=m/r,s=w/r),this.set(i,s,r,t),this}let x=Math.sqrt((p-_)*(p-_)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(x)<.001&&(x=1),this.x=(p-_)/x,this.y=(h-v)/x,this.z=(f-u)/x,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Vc=class extends Wi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new zt(0,0,e,t),this.scissorTest=!1,this.viewport=new zt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ti({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Bo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends Vc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ka=class extends ti{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Gc=class extends ti{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,p)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,p){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=f,g[3]=d,g[7]=_,g[11]=v,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/yo.setFromMatrixColumn(e,0).length(),r=1/yo.setFromMatrixColumn(e,1).length(),o=1/yo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+_*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=_+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,_=c*u,v=c*h;t[0]=f+v*a,t[4]=_*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-_,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,_=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=_+d*a,t[1]=d+_*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=_*c-d,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=d*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=_*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+_,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,d=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=d*h-_,t[2]=_*h-d,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Tb,e,Ab)}lookAt(e,t,i){let s=this.elements;return di.subVectors(e,t),di.lengthSq()===0&&(di.z=1),di.normalize(),Ks.crossVectors(i,di),Ks.lengthSq()===0&&(Math.abs(i.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),Ks.crossVectors(i,di)),Ks.normalize(),rc.crossVectors(di,Ks),s[0]=Ks.x,s[4]=rc.x,s[8]=di.x,s[1]=Ks.y,s[5]=rc.y,s[9]=di.y,s[2]=Ks.z,s[6]=rc.z,s[10]=di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],_=i[2],v=i[6],p=i[10],g=i[14],x=i[3],M=i[7],b=i[11],y=i[15],S=s[0],m=s[4],w=s[8],I=s[12],P=s[1],L=s[5],N=s[9],B=s[13],D=s[2],G=s[6],J=s[10],k=s[14],se=s[3],Y=s[7],K=s[11],q=s[15];return r[0]=o*S+a*P+l*D+c*se,r[4]=o*m+a*L+l*G+c*Y,r[8]=o*w+a*N+l*J+c*K,r[12]=o*I+a*B+l*k+c*q,r[1]=u*S+h*P+f*D+d*se,r[5]=u*m+h*L+f*G+d*Y,r[9]=u*w+h*N+f*J+d*K,r[13]=u*I+h*B+f*k+d*q,r[2]=_*S+v*P+p*D+g*se,r[6]=_*m+v*L+p*G+g*Y,r[10]=_*w+v*N+p*J+g*K,r[14]=_*I+v*B+p*k+g*q,r[3]=x*S+M*P+b*D+y*se,r[7]=x*m+M*L+b*G+y*Y,r[11]=x*w+M*N+b*J+y*K,r[15]=x*I+M*B+b*k+y*q,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],_=e[3],v=e[7],p=e[11],g=e[15],x=l*d-c*f,M=a*d-c*h,b=a*f-l*h,y=o*d-c*u,S=o*f-l*u,m=o*h-a*u;return t*(v*x-p*M+g*b)-i*(_*x-p*y+g*S)+s*(_*M-v*y+g*m)-r*(_*b-v*S+p*m)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],_=e[12],v=e[13],p=e[14],g=e[15],x=t*a-i*o,M=t*l-s*o,b=t*c-r*o,y=i*l-s*a,S=i*c-r*a,m=s*c-r*l,w=u*v-h*_,I=u*p-f*_,P=u*g-d*_,L=h*p-f*v,N=h*g-d*v,B=f*g-d*p,D=x*B-M*N+b*L+y*P-S*I+m*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/D;return e[0]=(a*B-l*N+c*L)*G,e[1]=(s*N-i*B-r*L)*G,e[2]=(v*m-p*S+g*y)*G,e[3]=(f*S-h*m-d*y)*G,e[4]=(l*P-o*B-c*I)*G,e[5]=(t*B-s*P+r*I)*G,e[6]=(p*b-_*m-g*M)*G,e[7]=(u*m-f*b+d*M)*G,e[8]=(o*N-a*P+c*w)*G,e[9]=(i*P-t*N-r*w)*G,e[10]=(_*S-v*b+g*x)*G,e[11]=(h*b-u*S-d*x)*G,e[12]=(a*I-o*L-l*w)*G,e[13]=(t*L-i*I+s*w)*G,e[14]=(v*M-_*y-p*x)*G,e[15]=(u*y-h*M+f*x)*G,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,_=r*h,v=o*u,p=o*h,g=a*h,x=l*c,M=l*u,b=l*h,y=i.x,S=i.y,m=i.z;return s[0]=(1-(v+g))*y,s[1]=(d+b)*y,s[2]=(_-M)*y,s[3]=0,s[4]=(d-b)*S,s[5]=(1-(f+g))*S,s[6]=(p+x)*S,s[7]=0,s[8]=(_+M)*m,s[9]=(p-x)*m,s[10]=(1-(f+v))*m,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=yo.set(s[0],s[1],s[2]).length(),a=yo.set(s[4],s[5],s[6]).length(),l=yo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),zi.copy(this);let c=1/o,u=1/a,h=1/l;return zi.elements[0]*=c,zi.elements[1]*=c,zi.elements[2]*=c,zi.elements[4]*=u,zi.elements[5]*=u,zi.elements[6]*=u,zi.elements[8]*=h,zi.elements[9]*=h,zi.elements[10]*=h,t.setFromRotationMatrix(zi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),_,v;if(l)_=r/(o-r),v=o*r/(o-r);else if(a===Ri)_=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Oo)_=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),_,v;if(l)_=1/(o-r),v=o/(o-r);else if(a===Ri)_=-2/(o-r),v=-(o+r)/(o-r);else if(a===Oo)_=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},yo=new X,zi=new gt,Tb=new X(0,0,0),Ab=new X(1,1,1),Ks=new X,rc=new X,di=new X,e0=new gt,t0=new Un,Cs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return e0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(e0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return t0.setFromEuler(this),this.setFromQuaternion(t0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cs.DEFAULT_ORDER="XYZ";var ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Eb=0,n0=new X,bo=new Un,ys=new gt,oc=new X,Ta=new X,Cb=new X,Rb=new Un,i0=new X(1,0,0),s0=new X(0,1,0),r0=new X(0,0,1),o0={type:"added"},Pb={type:"removed"},So={type:"childadded",child:null},wf={type:"childremoved",child:null},Bn=class n extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Eb++}),this.uuid=Jo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new Cs,i=new Un,s=new X(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new gt},normalMatrix:{value:new nt}}),this.matrix=new gt,this.matrixWorld=new gt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.multiply(bo),this}rotateOnWorldAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.premultiply(bo),this}rotateX(e){return this.rotateOnAxis(i0,e)}rotateY(e){return this.rotateOnAxis(s0,e)}rotateZ(e){return this.rotateOnAxis(r0,e)}translateOnAxis(e,t){return n0.copy(e).applyQuaternion(this.quaternion),this.position.add(n0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(i0,e)}translateY(e){return this.translateOnAxis(s0,e)}translateZ(e){return this.translateOnAxis(r0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ys.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?oc.copy(e):oc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ys.lookAt(Ta,oc,this.up):ys.lookAt(oc,Ta,this.up),this.quaternion.setFromRotationMatrix(ys),s&&(ys.extractRotation(s.matrixWorld),bo.setFromRotationMatrix(ys),this.quaternion.premultiply(bo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(o0),So.child=e,this.dispatchEvent(So),So.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Pb),wf.child=e,this.dispatchEvent(wf),wf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ys.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ys.multiply(e.parent.matrixWorld)),e.applyMatrix4(ys),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(o0),So.child=e,this.dispatchEvent(So),So.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,e,Cb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,Rb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Bn.DEFAULT_UP=new X(0,1,0);Bn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Bn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var as=class extends Bn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ib={type:"move"},zo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new as,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new as,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new as,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let p=t.getJointPose(v,i),g=this._getHandJoint(c,v);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,_=.005;c.inputState.pinching&&f>d+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ib)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new as;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},d_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},ac={h:0,s:0,l:0};function Tf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var at=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=Sd(e,1),t=yt(t,0,1),i=yt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Tf(o,r,e+1/3),this.g=Tf(o,r,e),this.b=Tf(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Gn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Gn){let i=d_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=As(e.r),this.g=As(e.g),this.b=As(e.b),this}copyLinearToSRGB(e){return this.r=Do(e.r),this.g=Do(e.g),this.b=Do(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Gn){return vt.workingToColorSpace(Vn.copy(this),e),Math.round(yt(Vn.r*255,0,255))*65536+Math.round(yt(Vn.g*255,0,255))*256+Math.round(yt(Vn.b*255,0,255))}getHexString(e=Gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Vn.copy(this),t);let i=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Vn.copy(this),t),e.r=Vn.r,e.g=Vn.g,e.b=Vn.b,e}getStyle(e=Gn){vt.workingToColorSpace(Vn.copy(this),e);let t=Vn.r,i=Vn.g,s=Vn.b;return e!==Gn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(js),this.setHSL(js.h+e,js.s+t,js.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(js),e.getHSL(ac);let i=Na(js.h,ac.h,t),s=Na(js.s,ac.s,t),r=Na(js.l,ac.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new at;at.NAMES=d_;var Nr=class extends Bn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cs,this.environmentIntensity=1,this.environmentRotation=new Cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Vi=new X,bs=new X,Af=new X,Ss=new X,Mo=new X,wo=new X,a0=new X,Ef=new X,Cf=new X,Rf=new X,Pf=new zt,If=new zt,Lf=new zt,nr=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Vi.subVectors(e,t),s.cross(Vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Vi.subVectors(s,t),bs.subVectors(i,t),Af.subVectors(e,t);let o=Vi.dot(Vi),a=Vi.dot(bs),l=Vi.dot(Af),c=bs.dot(bs),u=bs.dot(Af),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-d-_,_,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ss)===null?!1:Ss.x>=0&&Ss.y>=0&&Ss.x+Ss.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ss)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ss.x),l.addScaledVector(o,Ss.y),l.addScaledVector(a,Ss.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Pf.setScalar(0),If.setScalar(0),Lf.setScalar(0),Pf.fromBufferAttribute(e,t),If.fromBufferAttribute(e,i),Lf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Pf,r.x),o.addScaledVector(If,r.y),o.addScaledVector(Lf,r.z),o}static isFrontFacing(e,t,i,s){return Vi.subVectors(i,t),bs.subVectors(e,t),Vi.cross(bs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vi.subVectors(this.c,this.b),bs.subVectors(this.a,this.b),Vi.cross(bs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Mo.subVectors(s,i),wo.subVectors(r,i),Ef.subVectors(e,i);let l=Mo.dot(Ef),c=wo.dot(Ef);if(l<=0&&c<=0)return t.copy(i);Cf.subVectors(e,s);let u=Mo.dot(Cf),h=wo.dot(Cf);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Mo,o);Rf.subVectors(e,r);let d=Mo.dot(Rf),_=wo.dot(Rf);if(_>=0&&d<=_)return t.copy(r);let v=d*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(wo,a);let p=u*_-d*h;if(p<=0&&h-u>=0&&d-_>=0)return a0.subVectors(r,s),a=(h-u)/(h-u+(d-_)),t.copy(s).addScaledVector(a0,a);let g=1/(p+v+f);return o=v*g,a=f*g,t.copy(i).addScaledVector(Mo,o).addScaledVector(wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ls=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Gi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Gi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Gi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Gi):Gi.fromBufferAttribute(r,o),Gi.applyMatrix4(e.matrixWorld),this.expandByPoint(Gi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),lc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),lc.copy(i.boundingBox)),lc.applyMatrix4(e.matrixWorld),this.union(lc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Gi),Gi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Aa),cc.subVectors(this.max,Aa),To.subVectors(e.a,Aa),Ao.subVectors(e.b,Aa),Eo.subVectors(e.c,Aa),Qs.subVectors(Ao,To),er.subVectors(Eo,Ao),Pr.subVectors(To,Eo);let t=[0,-Qs.z,Qs.y,0,-er.z,er.y,0,-Pr.z,Pr.y,Qs.z,0,-Qs.x,er.z,0,-er.x,Pr.z,0,-Pr.x,-Qs.y,Qs.x,0,-er.y,er.x,0,-Pr.y,Pr.x,0];return!Df(t,To,Ao,Eo,cc)||(t=[1,0,0,0,1,0,0,0,1],!Df(t,To,Ao,Eo,cc))?!1:(uc.crossVectors(Qs,er),t=[uc.x,uc.y,uc.z],Df(t,To,Ao,Eo,cc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Gi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Gi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ms=[new X,new X,new X,new X,new X,new X,new X,new X],Gi=new X,lc=new ls,To=new X,Ao=new X,Eo=new X,Qs=new X,er=new X,Pr=new X,Aa=new X,cc=new X,uc=new X,Ir=new X;function Df(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ir.fromArray(n,r);let a=s.x*Math.abs(Ir.x)+s.y*Math.abs(Ir.y)+s.z*Math.abs(Ir.z),l=e.dot(Ir),c=t.dot(Ir),u=i.dot(Ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var pn=new X,hc=new tt,Lb=0,Zt=class extends Wi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Lb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=o_,this.updateRanges=[],this.gpuType=Ii,this.version=0,this._normalizationScale=e!==void 0?wd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)hc.fromBufferAttribute(this,t),hc.applyMatrix3(e),this.setXY(t,hc.x,hc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix3(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix4(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyNormalMatrix(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.transformDirection(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):h_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):f_(e,this.array)}},za=class extends Zt{constructor(e,t,i){super(new Int8Array(e),t,i)}},Va=class extends Zt{constructor(e,t,i){super(new Uint8Array(e),t,i)}};var Ga=class extends Zt{constructor(e,t,i){super(new Int16Array(e),t,i)}},Or=class extends Zt{constructor(e,t,i){super(new Uint16Array(e),t,i)}},Ha=class extends Zt{constructor(e,t,i){super(new Int32Array(e),t,i)}},Fr=class extends Zt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var bn=class extends Zt{constructor(e,t,i){super(new Float32Array(e),t,i)}},Db=new ls,Ea=new X,Nf=new X,Rs=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Db.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ea.subVectors(e,this.center);let t=Ea.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ea,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Nf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ea.copy(e.center).add(Nf)),this.expandByPoint(Ea.copy(e.center).sub(Nf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Nb=0,Ci=new gt,Of=new Bn,Co=new X,pi=new ls,Ca=new ls,Dn=new X,ni=class n extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Nb++}),this.uuid=Jo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(rb(e)?Fr:Or)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ci.makeRotationFromQuaternion(e),this.applyMatrix4(Ci),this}rotateX(e){return Ci.makeRotationX(e),this.applyMatrix4(Ci),this}rotateY(e){return Ci.makeRotationY(e),this.applyMatrix4(Ci),this}rotateZ(e){return Ci.makeRotationZ(e),this.applyMatrix4(Ci),this}translate(e,t,i){return Ci.makeTranslation(e,t,i),this.applyMatrix4(Ci),this}scale(e,t,i){return Ci.makeScale(e,t,i),this.applyMatrix4(Ci),this}lookAt(e){return Of.lookAt(e),Of.updateMatrix(),this.applyMatrix4(Of.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new bn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ls);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ca.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(pi.min,Ca.min),pi.expandByPoint(Dn),Dn.addVectors(pi.max,Ca.max),pi.expandByPoint(Dn)):(pi.expandByPoint(Ca.min),pi.expandByPoint(Ca.max))}pi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),Dn.add(Co)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new X,l[I]=new X;let u=new X,h=new X,f=new X,d=new tt,_=new tt,v=new tt,p=new X,g=new X;function x(I,P,L){c[I]=c[P]=c[L]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,P),f.fromBufferAttribute(i,L),d.fromBufferAttribute(r,I),_.fromBufferAttribute(r,P),v.fromBufferAttribute(r,L),h.sub(u),f.sub(u),_.sub(d),v.sub(d);let N=1/(_.x*v.y-v.x*_.y);isFinite(N)&&(p.copy(h).multiplyScalar(v.y).addScaledVector(f,-_.y).multiplyScalar(N),g.copy(f).multiplyScalar(_.x).addScaledVector(h,-v.x).multiplyScalar(N),a[I].add(p),a[P].add(p),a[L].add(p),l[I].add(g),l[P].add(g),l[L].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let I=0,P=M.length;I<P;++I){let L=M[I],N=L.start,B=L.count;for(let D=N,G=N+B;D<G;D+=3)x(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new X,y=new X,S=new X,m=new X;function w(I){S.fromBufferAttribute(s,I),m.copy(S);let P=a[I];b.copy(P),b.sub(S.multiplyScalar(S.dot(P))).normalize(),y.crossVectors(m,P);let N=y.dot(l[I])<0?-1:1;o.setXYZW(I,b.x,b.y,b.z,N)}for(let I=0,P=i.count;I<P;++I)c[I]&&w(I);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Zt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,h=new X;if(e)for(let f=0,d=e.count;f<d;f+=3){let _=e.getX(f+0),v=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,_=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let g=0;g<u;g++)f[_++]=c[d++]}return new Zt(f,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ff=new X,Ob=new X,Fb=new nt,Hi=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Ff.subVectors(i,t).cross(Ob.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Ff),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Fb.getNormalMatrix(e),s=this.coplanarPoint(Ff).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ub=0,Ps=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ub++}),this.uuid=Jo(),this.name="",this.type="Material",this.blending=qo,this.side=cr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=td,this.blendDst=nd,this.blendEquation=zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=No,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=e_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Rc,this.stencilZFail=Rc,this.stencilZPass=Rc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new at().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Hi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new tt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new X,Uf=new X,fc=new X,dc=new X,Vo=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Uf.copy(e).add(t).multiplyScalar(.5),fc.copy(t).sub(e).normalize(),dc.copy(this.origin).sub(Uf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(fc),a=dc.dot(this.direction),l=-dc.dot(fc),c=dc.lengthSq(),u=Math.abs(1-o*o),h,f,d,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){let v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Uf).addScaledVector(fc,f),d}intersectSphere(e,t){if(e.radius<0)return null;ws.subVectors(e.center,this.origin);let i=ws.dot(this.direction),s=ws.dot(ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,_=t.x-o.x,v=t.y-o.y,p=t.z-o.z,g=i.x-o.x,x=i.y-o.y,M=i.z-o.z,b=Math.abs(l),y=Math.abs(c),S=Math.abs(u),m,w,I,P,L,N,B,D,G,J,k,se;if(b>=y&&b>=S?(I=l,N=h,G=_,se=g,l>=0?(m=c,w=u,P=f,L=d,B=v,D=p,J=x,k=M):(m=u,w=c,P=d,L=f,B=p,D=v,J=M,k=x)):y>=S?(I=c,N=f,G=v,se=x,c>=0?(m=u,w=l,P=d,L=h,B=p,D=_,J=M,k=g):(m=l,w=u,P=h,L=d,B=_,D=p,J=g,k=M)):(I=u,N=d,G=p,se=M,u>=0?(m=l,w=c,P=h,L=f,B=_,D=v,J=g,k=x):(m=c,w=l,P=f,L=h,B=v,D=_,J=x,k=g)),I===0)return null;let Y=m/I,K=w/I,q=1/I,ie=P-Y*N,ne=L-K*N,j=B-Y*G,he=D-K*G,pe=J-Y*se,_e=k-K*se,xe=pe*he-_e*j,Ge=ie*_e-ne*pe,rt=j*ne-he*ie;if(s){if(xe<0||Ge<0||rt<0)return null}else if((xe<0||Ge<0||rt<0)&&(xe>0||Ge>0||rt>0))return null;let He=xe+Ge+rt;if(He===0)return null;let ft=q*(xe*N+Ge*G+rt*se);return(He>0?ft<0:ft>0)?null:this.at(ft/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Is=class extends Ps{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=au,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},l0=new gt,Lr=new Vo,pc=new Rs,c0=new X,mc=new X,gc=new X,_c=new X,Bf=new X,xc=new X,u0=new X,vc=new X,On=class extends Bn{constructor(e=new ni,t=new Is){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){xc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Bf.fromBufferAttribute(h,e),o?xc.addScaledVector(Bf,u):xc.addScaledVector(Bf.sub(t),u))}t.add(xc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),pc.copy(i.boundingSphere),pc.applyMatrix4(r),Lr.copy(e.ray).recast(e.near),!(pc.containsPoint(Lr.origin)===!1&&(Lr.intersectSphere(pc,c0)===null||Lr.origin.distanceToSquared(c0)>(e.far-e.near)**2))&&(l0.copy(r).invert(),Lr.copy(e.ray).applyMatrix4(l0),!(i.boundingBox!==null&&Lr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Lr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let p=f[_],g=o[p.materialIndex],x=Math.max(p.start,d.start),M=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let b=x,y=M;b<y;b+=3){let S=a.getX(b),m=a.getX(b+1),w=a.getX(b+2);s=yc(this,g,e,i,c,u,h,S,m,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let p=_,g=v;p<g;p+=3){let x=a.getX(p),M=a.getX(p+1),b=a.getX(p+2);s=yc(this,o,e,i,c,u,h,x,M,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let p=f[_],g=o[p.materialIndex],x=Math.max(p.start,d.start),M=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let b=x,y=M;b<y;b+=3){let S=b,m=b+1,w=b+2;s=yc(this,g,e,i,c,u,h,S,m,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let p=_,g=v;p<g;p+=3){let x=p,M=p+1,b=p+2;s=yc(this,o,e,i,c,u,h,x,M,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function Bb(n,e,t,i,s,r,o,a){let l;if(e.side===Qn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===cr,a),l===null)return null;vc.copy(a),vc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(vc);return c<t.near||c>t.far?null:{distance:c,point:vc.clone(),object:n}}function yc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,mc),n.getVertexPosition(l,gc),n.getVertexPosition(c,_c);let u=Bb(n,e,t,i,mc,gc,_c,u0);if(u){let h=new X;nr.getBarycoord(u0,mc,gc,_c,h),s&&(u.uv=nr.getInterpolatedAttribute(s,a,l,c,h,new tt)),r&&(u.uv1=nr.getInterpolatedAttribute(r,a,l,c,h,new tt)),o&&(u.normal=nr.getInterpolatedAttribute(o,a,l,c,h,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new X,materialIndex:0};nr.getNormal(mc,gc,_c,f.normal),u.face=f,u.barycoord=h}return u}var Ur=class extends ti{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Nn,u=Nn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Wa=class extends Zt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Ro=new gt,h0=new gt,bc=[],f0=new ls,kb=new gt,Ra=new On,Pa=new Rs,Xa=class extends On{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Wa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,kb)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ls),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Ro),f0.copy(e.boundingBox).applyMatrix4(Ro),this.boundingBox.union(f0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Rs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Ro),Pa.copy(e.boundingSphere).applyMatrix4(Ro),this.boundingSphere.union(Pa)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Ra.geometry=this.geometry,Ra.material=this.material,Ra.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Pa.copy(this.boundingSphere),Pa.applyMatrix4(i),e.ray.intersectsSphere(Pa)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ro),h0.multiplyMatrices(i,Ro),Ra.matrixWorld=h0,Ra.raycast(e,bc);for(let o=0,a=bc.length;o<a;o++){let l=bc[o];l.instanceId=r,l.object=this,t.push(l)}bc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Wa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ur(new Float32Array(s*this.count),s,this.count,pu,Ii));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Dr=new Rs,zb=new tt(.5,.5),Sc=new X,ir=class{constructor(e=new Hi,t=new Hi,i=new Hi,s=new Hi,r=new Hi,o=new Hi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ri,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],_=r[8],v=r[9],p=r[10],g=r[11],x=r[12],M=r[13],b=r[14],y=r[15];if(s[0].setComponents(c-o,d-u,g-_,y-x).normalize(),s[1].setComponents(c+o,d+u,g+_,y+x).normalize(),s[2].setComponents(c+a,d+h,g+v,y+M).normalize(),s[3].setComponents(c-a,d-h,g-v,y-M).normalize(),i)s[4].setComponents(l,f,p,b).normalize(),s[5].setComponents(c-l,d-f,g-p,y-b).normalize();else if(s[4].setComponents(c-l,d-f,g-p,y-b).normalize(),t===Ri)s[5].setComponents(c+l,d+f,g+p,y+b).normalize();else if(t===Oo)s[5].setComponents(l,f,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Dr)}intersectsSprite(e){Dr.center.set(0,0,0);let t=zb.distanceTo(e.center);return Dr.radius=.7071067811865476+t,Dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Dr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Sc.x=s.normal.x>0?e.max.x:e.min.x,Sc.y=s.normal.y>0?e.max.y:e.min.y,Sc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Sc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},d0=new gt,Hc=class n{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];d0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ir),i[s].setFromProjectionMatrix(d0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ir),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Go=class extends Ps{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Wc=new X,Xc=new X,p0=new gt,Ia=new Vo,Mc=new Rs,kf=new X,m0=new X,qc=class extends Bn{constructor(e=new ni,t=new Go){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Wc.fromBufferAttribute(t,s-1),Xc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Wc.distanceTo(Xc);e.setAttribute("lineDistance",new bn(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Mc.copy(i.boundingSphere),Mc.applyMatrix4(s),Mc.radius+=r,e.ray.intersectsSphere(Mc)===!1)return;p0.copy(s).invert(),Ia.copy(e.ray).applyMatrix4(p0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let v=d,p=_-1;v<p;v+=c){let g=u.getX(v),x=u.getX(v+1),M=wc(this,e,Ia,l,g,x,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(_-1),p=u.getX(d),g=wc(this,e,Ia,l,v,p,_-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let v=d,p=_-1;v<p;v+=c){let g=wc(this,e,Ia,l,v,v+1,v);g&&t.push(g)}if(this.isLineLoop){let v=wc(this,e,Ia,l,_-1,d,_-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function wc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Wc.fromBufferAttribute(a,s),Xc.fromBufferAttribute(a,r),t.distanceSqToSegment(Wc,Xc,kf,m0)>i)return;kf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(kf);if(!(c<e.near||c>e.far))return{distance:c,point:m0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var g0=new X,_0=new X,qa=class extends qc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)g0.fromBufferAttribute(t,s),_0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+g0.distanceTo(_0);e.setAttribute("lineDistance",new bn(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ya=class extends ti{constructor(e=[],t=Vr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ls=class extends ti{constructor(e,t,i=Xi,s,r,o,a=Nn,l=Nn,c,u=Es,h=1){if(u!==Es&&u!==Os)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Bo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},$a=class extends Ls{constructor(e,t=Xi,i=Vr,s,r,o=Nn,a=Nn,l,c=Es){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ja=class extends ti{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ho=class n extends ni{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new bn(c,3)),this.setAttribute("normal",new bn(u,3)),this.setAttribute("uv",new bn(h,2));function _(v,p,g,x,M,b,y,S,m,w,I){let P=b/m,L=y/w,N=b/2,B=y/2,D=S/2,G=m+1,J=w+1,k=0,se=0,Y=new X;for(let K=0;K<J;K++){let q=K*L-B;for(let ie=0;ie<G;ie++){let ne=ie*P-N;Y[v]=ne*x,Y[p]=q*M,Y[g]=D,c.push(Y.x,Y.y,Y.z),Y[v]=0,Y[p]=0,Y[g]=S>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(ie/m),h.push(1-K/w),k+=1}}for(let K=0;K<w;K++)for(let q=0;q<m;q++){let ie=f+q+G*K,ne=f+q+G*(K+1),j=f+(q+1)+G*(K+1),he=f+(q+1)+G*K;l.push(ie,ne,he),l.push(ne,j,he),se+=6}a.addGroup(d,se,I),d+=se,f+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Za=class n extends ni{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],_=[],v=[],p=[];for(let g=0;g<u;g++){let x=g*f-o;for(let M=0;M<c;M++){let b=M*h-r;_.push(b,-x,0),v.push(0,0,1),p.push(M/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let M=x+c*g,b=x+c*(g+1),y=x+1+c*(g+1),S=x+1+c*g;d.push(M,b,S),d.push(b,y,S)}this.setIndex(d),this.setAttribute("position",new bn(_,3)),this.setAttribute("normal",new bn(v,3)),this.setAttribute("uv",new bn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var sr=class n extends ni{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new X,f=new X,d=[],_=[],v=[],p=[];for(let g=0;g<=i;g++){let x=[],M=g/i,b=o+M*a,y=e*Math.cos(b),S=Math.sqrt(e*e-y*y),m=0;g===0&&o===0?m=.5/t:g===i&&l===Math.PI&&(m=-.5/t);for(let w=0;w<=t;w++){let I=w/t,P=s+I*r;h.x=-S*Math.cos(P),h.y=y,h.z=S*Math.sin(P),_.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),p.push(I+m,1-M),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<t;x++){let M=u[g][x+1],b=u[g][x],y=u[g+1][x],S=u[g+1][x+1];(g!==0||o>0)&&d.push(M,b,S),(g!==i-1||l<Math.PI)&&d.push(b,y,S)}this.setIndex(d),this.setAttribute("position",new bn(_,3)),this.setAttribute("normal",new bn(v,3)),this.setAttribute("uv",new bn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Hr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(x0(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(x0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Hn(n){let e={};for(let t=0;t<n.length;t++){let i=Hr(n[t]);for(let s in i)e[s]=i[s]}return e}function x0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Vb(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Td(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var p_={clone:Hr,merge:Hn},Gb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Pi=class extends Ps{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Gb,this.fragmentShader=Hb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hr(e.uniforms),this.uniformsGroups=Vb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new at().setHex(s.value);break;case"v2":this.uniforms[i].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new zt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new gt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Yc=class extends Pi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ka=class extends Ps{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=$u,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=au,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},$c=class extends Ps{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=j0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Jc=class extends Ps{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Po(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Tc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var rr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Zc=class extends rr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gf,endingEnd:Gf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hf:r=e,a=2*t-i;break;case Wf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hf:o=e,l=2*i-t;break;case Wf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,_=(i-t)/(s-t),v=_*_,p=v*_,g=-f*p+2*f*v-f*_,x=(1+f)*p+(-1.5-2*f)*v+(-.5+f)*_+1,M=(-1-d)*p+(1.5+d)*v+.5*_,b=d*p-d*v;for(let y=0;y!==a;++y)r[y]=g*o[u+y]+x*o[c+y]+M*o[l+y]+b*o[h+y];return r}},Kc=class extends rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},jc=class extends rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Qc=class extends rr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let _=(i-t)/(s-t),v=1-_;for(let p=0;p!==a;++p)r[p]=o[c+p]*v+o[l+p]*_;return r}let f=a*2,d=e-1;for(let _=0;_!==a;++_){let v=o[c+_],p=o[l+_],g=d*f+_*2,x=h[g],M=h[g+1],b=e*f+_*2,y=u[b],S=u[b+1],m=Xb(i,t,x,y,s);r[_]=m_(m,v,M,S,p)}return r}};function m_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function Wb(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Xb(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=m_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Wb(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var _i=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Po(t,this.TimeBufferType),this.values=Po(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Po(e.times,Array),values:Po(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Tc(e.settings)&&(i.settings={inTangents:Po(e.settings.inTangents,Array),outTangents:Po(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Kc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Zc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Qc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Oa:t=this.InterpolantFactoryMethodDiscrete;break;case kc:t=this.InterpolantFactoryMethodLinear;break;case Cc:t=this.InterpolantFactoryMethodSmooth;break;case Vf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Oa;case this.InterpolantFactoryMethodLinear:return kc;case this.InterpolantFactoryMethodSmooth:return Cc;case this.InterpolantFactoryMethodBezier:return Vf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Tc(this.settings)&&(v0(this.settings.inTangents,e),v0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Tc(this.settings)&&(y0(this.settings.inTangents,e),y0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&ob(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Cc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let _=0;_!==i;++_){let v=t[h+_];if(v!==t[f+_]||v!==t[d+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Tc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function v0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function y0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=kc;var or=class extends _i{constructor(e,t,i){super(e,t,i)}};or.prototype.ValueTypeName="bool";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Oa;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var eu=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};eu.prototype.ValueTypeName="color";var tu=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};tu.prototype.ValueTypeName="number";var nu=class extends rr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Un.slerpFlat(r,0,o,c-a,o,c,l);return r}},ja=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new nu(this.times,this.values,this.getValueSize(),e)}};ja.prototype.ValueTypeName="quaternion";ja.prototype.InterpolantFactoryMethodSmooth=void 0;var ar=class extends _i{constructor(e,t,i){super(e,t,i)}};ar.prototype.ValueTypeName="string";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Oa;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var iu=class extends _i{constructor(e,t,i,s){super(e,t,i,s)}};iu.prototype.ValueTypeName="vector";var Xf={enabled:!1,files:{},add:function(n,e){this.enabled!==!1&&(b0(n)||(this.files[n]=e))},get:function(n){if(this.enabled!==!1&&!b0(n))return this.files[n]},remove:function(n){delete this.files[n]},clear:function(){this.files={}}};function b0(n){try{let e=n.slice(n.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var su=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],_=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},g_=new su,Br=class{constructor(e){this.manager=e!==void 0?e:g_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Br.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ts={},qf=class extends Error{constructor(e,t){super(e),this.response=t}},Qa=class extends Br{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,i,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Xf.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Ts[e]!==void 0){Ts[e].push({onLoad:t,onProgress:i,onError:s});return}Ts[e]=[],Ts[e].push({onLoad:t,onProgress:i,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Ye("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Ts[e],h=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),d=f?parseInt(f):0,_=d!==0,v=0,p=new ReadableStream({start(g){x();function x(){h.read().then(({done:M,value:b})=>{if(M)g.close();else{v+=b.byteLength;let y=new ProgressEvent("progress",{lengthComputable:_,loaded:v,total:d});for(let S=0,m=u.length;S<m;S++){let w=u[S];w.onProgress&&w.onProgress(y)}g.enqueue(b),x()}},M=>{g.error(M)})}}});return new Response(p)}else throw new qf(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),f=h&&h[1]?h[1].toLowerCase():void 0,d=new TextDecoder(f);return c.arrayBuffer().then(_=>d.decode(_))}}}).then(c=>{Xf.add(`file:${e}`,c);let u=Ts[e];delete Ts[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onLoad&&d.onLoad(c)}}).catch(c=>{let u=Ts[e];if(u===void 0)throw this.manager.itemError(e),c;delete Ts[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onError&&d.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var el=class extends Bn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},tl=class extends el{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},zf=new gt,S0=new X,M0=new X,ru=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new gt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ir,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new zt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;S0.setFromMatrixPosition(e.matrixWorld),t.position.copy(S0),M0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(M0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){zf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(zf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Oo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(zf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ac=new X,Ec=new Un,rs=new X,nl=class extends Bn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new gt,this.projectionMatrix=new gt,this.projectionMatrixInverse=new gt,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ac,Ec,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ac,Ec,rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Ac,Ec,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ac,Ec,rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},tr=new X,w0=new tt,T0=new tt,mi=class extends nl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Uo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Da*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Uo*2*Math.atan(Math.tan(Da*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(tr.x,tr.y).multiplyScalar(-e/tr.z),tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(tr.x,tr.y).multiplyScalar(-e/tr.z)}getViewSize(e,t){return this.getViewBounds(e,w0,T0),t.subVectors(T0,w0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Da*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ds=class extends nl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Yf=class extends ru{constructor(){super(new Ds(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},il=class extends el{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.target=new Bn,this.shadow=new Yf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Io=-90,Lo=1,Wo=class extends Bn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new mi(Io,Lo,e,t);s.layers=this.layers,this.add(s);let r=new mi(Io,Lo,e,t);r.layers=this.layers,this.add(r);let o=new mi(Io,Lo,e,t);o.layers=this.layers,this.add(o);let a=new mi(Io,Lo,e,t);a.layers=this.layers,this.add(a);let l=new mi(Io,Lo,e,t);l.layers=this.layers,this.add(l);let c=new mi(Io,Lo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ri)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},ou=class extends mi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Ad="\\[\\]\\.:\\/",qb=new RegExp("["+Ad+"]","g"),Ed="[^"+Ad+"]",Yb="[^"+Ad.replace("\\.","")+"]",$b=/((?:WC+[\/:])*)/.source.replace("WC",Ed),Jb=/(WCOD+)?/.source.replace("WCOD",Yb),Zb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ed),Kb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ed),jb=new RegExp("^"+$b+Jb+Zb+Kb+"$"),Qb=["material","materials","bones","map"],$f=class{constructor(e,t,i){let s=i||Yt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Yt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(qb,"")}static parseTrackName(e){let t=jb.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Qb.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Yt.Composite=$f;Yt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Yt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Yt.prototype.GetterByBindingType=[Yt.prototype._getValue_direct,Yt.prototype._getValue_array,Yt.prototype._getValue_arrayElement,Yt.prototype._getValue_toArray];Yt.prototype.SetterByBindingTypeAndVersioning=[[Yt.prototype._setValue_direct,Yt.prototype._setValue_direct_setNeedsUpdate,Yt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Yt.prototype._setValue_array,Yt.prototype._setValue_array_setNeedsUpdate,Yt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Yt.prototype._setValue_arrayElement,Yt.prototype._setValue_arrayElement_setNeedsUpdate,Yt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Yt.prototype._setValue_fromArray,Yt.prototype._setValue_fromArray_setNeedsUpdate,Yt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var RE=new Float32Array(1);var A0=new gt,sl=class{constructor(e,t,i=0,s=1/0){this.ray=new Vo(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ko,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return A0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(A0),this}intersectObject(e,t=!0,i=[]){return Jf(e,this,i,t),i.sort(E0),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Jf(e[s],this,i,t);return i.sort(E0),i}};function E0(n,e){return n.distance-e.distance}function Jf(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Jf(r[o],e,t,!0)}}var Zf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var rl=class extends Wi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Cd(n,e,t,i){let s=eS(i);switch(t){case md:return n*e;case pu:return n*e/s.components*s.byteLength;case mu:return n*e/s.components*s.byteLength;case ur:return n*e*2/s.components*s.byteLength;case gu:return n*e*2/s.components*s.byteLength;case gd:return n*e*3/s.components*s.byteLength;case Yi:return n*e*4/s.components*s.byteLength;case _u:return n*e*4/s.components*s.byteLength;case ll:case cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ul:case hl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case vu:case bu:return Math.max(n,16)*Math.max(e,8)/4;case xu:case yu:return Math.max(n,8)*Math.max(e,8)/2;case Su:case Mu:case Tu:case Au:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case wu:case fl:case Eu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Cu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ru:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Pu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Iu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Lu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Du:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Nu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ou:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Fu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Uu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Bu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ku:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case zu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Vu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Gu:case Hu:case Wu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Xu:case qu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case dl:case Yu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function eS(n){switch(n){case si:case hd:return{byteLength:1,components:1};case $o:case fd:case qi:return{byteLength:2,components:1};case fu:case du:return{byteLength:2,components:4};case Xi:case hu:case Ii:return{byteLength:4,components:1};case dd:case pd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function B_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function nS(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,_)=>d.start-_.start);let f=0;for(let d=1;d<h.length;d++){let _=h[f],v=h[d];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,_=h.length;d<_;d++){let v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var iS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,sS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,rS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,oS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,aS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,lS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,cS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,uS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,hS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,fS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,dS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,pS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,mS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,gS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,_S=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,xS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,vS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,yS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,bS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,SS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,MS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,wS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,TS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,AS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,ES=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,CS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,RS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,PS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,IS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,LS="gl_FragColor = linearToOutputTexel( gl_FragColor );",DS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,NS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,OS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,FS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,US=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,BS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,kS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,zS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,VS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,GS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,HS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,WS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,XS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,YS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,$S=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,JS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ZS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,KS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,jS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,QS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,eM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,tM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,nM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,iM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,sM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,rM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,oM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,aM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,cM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,uM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,hM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,fM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,dM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,pM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,mM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,gM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,_M=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,vM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,bM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,SM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,MM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,TM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,AM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,EM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,CM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,RM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,PM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,IM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,LM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,DM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,NM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,OM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,FM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,UM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,BM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,kM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,zM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,VM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,GM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,HM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,WM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,XM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,qM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,YM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,$M=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,JM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ZM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,KM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,jM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,QM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,ew=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,tw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,nw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,iw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ow=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,aw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,cw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,uw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,hw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,fw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,dw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,mw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,gw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,_w=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,bw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Sw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Mw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ww=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Aw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Ew=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Rw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Iw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Lw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Dw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Nw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ow=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:iS,alphahash_pars_fragment:sS,alphamap_fragment:rS,alphamap_pars_fragment:oS,alphatest_fragment:aS,alphatest_pars_fragment:lS,aomap_fragment:cS,aomap_pars_fragment:uS,batching_pars_vertex:hS,batching_vertex:fS,begin_vertex:dS,beginnormal_vertex:pS,bsdfs:mS,iridescence_fragment:gS,bumpmap_pars_fragment:_S,clipping_planes_fragment:xS,clipping_planes_pars_fragment:vS,clipping_planes_pars_vertex:yS,clipping_planes_vertex:bS,color_fragment:SS,color_pars_fragment:MS,color_pars_vertex:wS,color_vertex:TS,common:AS,defaultnormal_vertex:ES,displacementmap_pars_vertex:CS,displacementmap_vertex:RS,emissivemap_fragment:PS,emissivemap_pars_fragment:IS,colorspace_fragment:LS,colorspace_pars_fragment:DS,envmap_fragment:NS,envmap_common_pars_fragment:OS,envmap_pars_fragment:FS,envmap_pars_vertex:US,envmap_physical_pars_fragment:$S,envmap_vertex:BS,fog_vertex:kS,fog_pars_vertex:zS,fog_fragment:VS,fog_pars_fragment:GS,gradientmap_pars_fragment:HS,lightmap_pars_fragment:WS,lights_lambert_fragment:XS,lights_lambert_pars_fragment:qS,lights_pars_begin:YS,lights_toon_fragment:JS,lights_toon_pars_fragment:ZS,lights_phong_fragment:KS,lights_phong_pars_fragment:jS,lights_physical_fragment:QS,lights_physical_pars_fragment:eM,lights_fragment_begin:tM,lights_fragment_maps:nM,lights_fragment_end:iM,lightprobes_pars_fragment:sM,logdepthbuf_fragment:rM,logdepthbuf_pars_fragment:oM,logdepthbuf_pars_vertex:aM,logdepthbuf_vertex:lM,map_fragment:cM,map_pars_fragment:uM,map_particle_fragment:hM,map_particle_pars_fragment:fM,metalnessmap_fragment:dM,metalnessmap_pars_fragment:pM,morphinstance_vertex:mM,morphcolor_vertex:gM,morphnormal_vertex:_M,morphtarget_pars_vertex:xM,morphtarget_vertex:vM,normal_fragment_begin:yM,normal_fragment_maps:bM,normal_pars_fragment:SM,normal_pars_vertex:MM,normal_vertex:wM,normalmap_pars_fragment:TM,clearcoat_normal_fragment_begin:AM,clearcoat_normal_fragment_maps:EM,clearcoat_pars_fragment:CM,iridescence_pars_fragment:RM,opaque_fragment:PM,packing:IM,premultiplied_alpha_fragment:LM,project_vertex:DM,dithering_fragment:NM,dithering_pars_fragment:OM,roughnessmap_fragment:FM,roughnessmap_pars_fragment:UM,shadowmap_pars_fragment:BM,shadowmap_pars_vertex:kM,shadowmap_vertex:zM,shadowmask_pars_fragment:VM,skinbase_vertex:GM,skinning_pars_vertex:HM,skinning_vertex:WM,skinnormal_vertex:XM,specularmap_fragment:qM,specularmap_pars_fragment:YM,tonemapping_fragment:$M,tonemapping_pars_fragment:JM,transmission_fragment:ZM,transmission_pars_fragment:KM,uv_pars_fragment:jM,uv_pars_vertex:QM,uv_vertex:ew,worldpos_vertex:tw,background_vert:nw,background_frag:iw,backgroundCube_vert:sw,backgroundCube_frag:rw,cube_vert:ow,cube_frag:aw,depth_vert:lw,depth_frag:cw,distance_vert:uw,distance_frag:hw,equirect_vert:fw,equirect_frag:dw,linedashed_vert:pw,linedashed_frag:mw,meshbasic_vert:gw,meshbasic_frag:_w,meshlambert_vert:xw,meshlambert_frag:vw,meshmatcap_vert:yw,meshmatcap_frag:bw,meshnormal_vert:Sw,meshnormal_frag:Mw,meshphong_vert:ww,meshphong_frag:Tw,meshphysical_vert:Aw,meshphysical_frag:Ew,meshtoon_vert:Cw,meshtoon_frag:Rw,points_vert:Pw,points_frag:Iw,shadow_vert:Lw,shadow_frag:Dw,sprite_vert:Nw,sprite_frag:Ow},Le={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},hs={basic:{uniforms:Hn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Hn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Hn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Hn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Hn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new at(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Hn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Hn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Hn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Hn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Hn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Hn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Hn([Le.common,Le.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Hn([Le.lights,Le.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};hs.physical={uniforms:Hn([hs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Zu={r:0,b:0,g:0},Fw=new gt,k_=new nt;k_.set(-1,0,0,0,1,0,0,0,1);function Uw(n,e,t,i,s,r){let o=new at(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let b=x.backgroundBlurriness>0;M=e.get(M,b)}return M}function _(x){let M=!1,b=d(x);b===null?p(o,a):b&&b.isColor&&(p(b,1),M=!0);let y=n.xr.getEnvironmentBlendMode();y==="additive"?t.buffers.color.setClear(0,0,0,1,r):y==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(x,M){let b=d(M);b&&b.isCubeTexture?(c===void 0&&(c=new On(new Ho(1,1,1),new Pi({name:"BackgroundCubeMaterial",uniforms:Hr(hs.backgroundCube.uniforms),vertexShader:hs.backgroundCube.vertexShader,fragmentShader:hs.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(y,S,m){this.matrixWorld.copyPosition(m.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Fw.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(k_),c.material.toneMapped=vt.getTransfer(b.colorSpace)!==Ct,(u!==b||h!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new On(new Za(2,2),new Pi({name:"BackgroundMaterial",uniforms:Hr(hs.background.uniforms),vertexShader:hs.background.vertexShader,fragmentShader:hs.background.fragmentShader,side:cr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=vt.getTransfer(b.colorSpace)!==Ct,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,M){x.getRGB(Zu,Td(n)),t.buffers.color.setClear(Zu.r,Zu.g,Zu.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:_,addToRenderList:v,dispose:g}}function Bw(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(L,N,B,D,G){let J=!1,k=h(L,D,B,N);r!==k&&(r=k,c(r.object)),J=d(L,D,B,G),J&&_(L,D,B,G),G!==null&&e.update(G,n.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,b(L,N,B,D),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,N,B,D){let G=D.wireframe===!0,J=i[N.id];J===void 0&&(J={},i[N.id]=J);let k=L.isInstancedMesh===!0?L.id:0,se=J[k];se===void 0&&(se={},J[k]=se);let Y=se[B.id];Y===void 0&&(Y={},se[B.id]=Y);let K=Y[G];return K===void 0&&(K=f(l()),Y[G]=K),K}function f(L){let N=[],B=[],D=[];for(let G=0;G<t;G++)N[G]=0,B[G]=0,D[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:B,attributeDivisors:D,object:L,attributes:{},index:null}}function d(L,N,B,D){let G=r.attributes,J=N.attributes,k=0,se=B.getAttributes();for(let Y in se)if(se[Y].location>=0){let q=G[Y],ie=J[Y];if(ie===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor)),q===void 0||q.attribute!==ie||ie&&q.data!==ie.data)return!0;k++}return r.attributesNum!==k||r.index!==D}function _(L,N,B,D){let G={},J=N.attributes,k=0,se=B.getAttributes();for(let Y in se)if(se[Y].location>=0){let q=J[Y];q===void 0&&(Y==="instanceMatrix"&&L.instanceMatrix&&(q=L.instanceMatrix),Y==="instanceColor"&&L.instanceColor&&(q=L.instanceColor));let ie={};ie.attribute=q,q&&q.data&&(ie.data=q.data),G[Y]=ie,k++}r.attributes=G,r.attributesNum=k,r.index=D}function v(){let L=r.newAttributes;for(let N=0,B=L.length;N<B;N++)L[N]=0}function p(L){g(L,0)}function g(L,N){let B=r.newAttributes,D=r.enabledAttributes,G=r.attributeDivisors;B[L]=1,D[L]===0&&(n.enableVertexAttribArray(L),D[L]=1),G[L]!==N&&(n.vertexAttribDivisor(L,N),G[L]=N)}function x(){let L=r.newAttributes,N=r.enabledAttributes;for(let B=0,D=N.length;B<D;B++)N[B]!==L[B]&&(n.disableVertexAttribArray(B),N[B]=0)}function M(L,N,B,D,G,J,k){k===!0?n.vertexAttribIPointer(L,N,B,G,J):n.vertexAttribPointer(L,N,B,D,G,J)}function b(L,N,B,D){v();let G=D.attributes,J=B.getAttributes(),k=N.defaultAttributeValues;for(let se in J){let Y=J[se];if(Y.location>=0){let K=G[se];if(K===void 0&&(se==="instanceMatrix"&&L.instanceMatrix&&(K=L.instanceMatrix),se==="instanceColor"&&L.instanceColor&&(K=L.instanceColor)),K!==void 0){let q=K.normalized,ie=K.itemSize,ne=e.get(K);if(ne===void 0)continue;let j=ne.buffer,he=ne.type,pe=ne.bytesPerElement,_e=he===n.INT||he===n.UNSIGNED_INT||K.gpuType===hu;if(K.isInterleavedBufferAttribute){let xe=K.data,Ge=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,rt=K.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let He=0;He<Y.locationSize;He++)g(Y.location+He,xe.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let He=0;He<Y.locationSize;He++)p(Y.location+He);n.bindBuffer(n.ARRAY_BUFFER,j);for(let He=0;He<Y.locationSize;He++)M(Y.location+He,ie/Y.locationSize,he,q,Ge*pe,(rt+ie/Y.locationSize*He)*pe,_e)}else{if(K.isInstancedBufferAttribute){for(let xe=0;xe<Y.locationSize;xe++)g(Y.location+xe,K.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let xe=0;xe<Y.locationSize;xe++)p(Y.location+xe);n.bindBuffer(n.ARRAY_BUFFER,j);for(let xe=0;xe<Y.locationSize;xe++)M(Y.location+xe,ie/Y.locationSize,he,q,ie*pe,ie/Y.locationSize*xe*pe,_e)}}else if(k!==void 0){let q=k[se];if(q!==void 0)switch(q.length){case 2:n.vertexAttrib2fv(Y.location,q);break;case 3:n.vertexAttrib3fv(Y.location,q);break;case 4:n.vertexAttrib4fv(Y.location,q);break;default:n.vertexAttrib1fv(Y.location,q)}}}}x()}function y(){I();for(let L in i){let N=i[L];for(let B in N){let D=N[B];for(let G in D){let J=D[G];for(let k in J)u(J[k].object),delete J[k];delete D[G]}}delete i[L]}}function S(L){if(i[L.id]===void 0)return;let N=i[L.id];for(let B in N){let D=N[B];for(let G in D){let J=D[G];for(let k in J)u(J[k].object),delete J[k];delete D[G]}}delete i[L.id]}function m(L){for(let N in i){let B=i[N];for(let D in B){let G=B[D];if(G[L.id]===void 0)continue;let J=G[L.id];for(let k in J)u(J[k].object),delete J[k];delete G[L.id]}}}function w(L){for(let N in i){let B=i[N],D=L.isInstancedMesh===!0?L.id:0,G=B[D];if(G!==void 0){for(let J in G){let k=G[J];for(let se in k)u(k[se].object),delete k[se];delete G[J]}delete B[D],Object.keys(B).length===0&&delete i[N]}}}function I(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:P,dispose:y,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:m,initAttributes:v,enableAttribute:p,disableUnusedAttributes:x}}function kw(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function zw(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let m=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(m.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(m){return!(m!==Yi&&i.convert(m)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(m){let w=m===qi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(m!==si&&m!==Ii&&!w&&i.convert(m)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(m){if(m==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";m="mediump"}return m==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),y=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:b,maxSamples:y,samples:S}}function Vw(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Hi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let _=h.clippingPlanes,v=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||_===null||_.length===0||r&&!p)r?u(null):c();else{let x=r?0:i,M=x*4,b=g.clippingState||null;l.value=b,b=u(_,f,M,d);for(let y=0;y!==M;++y)b[y]=t[y];g.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,_){let v=h!==null?h.length:0,p=null;if(v!==0){if(p=l.value,_!==!0||p===null){let g=d+v*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<g)&&(p=new Float32Array(g));for(let M=0,b=d;M!==v;++M,b+=4)o.copy(h[M]).applyMatrix4(x,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}var gl=class extends gi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ya(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ho(5,5,5),r=new Pi({name:"CubemapFromEquirect",uniforms:Hr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qn,blending:kr});r.uniforms.tEquirect.value=t;let o=new On(s,r),a=t.minFilter;return t.minFilter===Ns&&(t.minFilter=jn),new Wo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},__=256,Gw=3,Hw=20,z_=256,V_=16,Ww=3,Xw=new X,qw=new at,ju=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Wo(1,10,null),this._boxMesh=new On(new Ho(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=Xw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,_=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(qw));let p=new Wo(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=_,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=y_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=v_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(__,Md(e))}_fromTexture(e,t){e.mapping===Vr||e.mapping===Yo?this._setSize(e.image.length===0?__:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=x_(e,!1,!1),i=Math.log2(e)-Gw;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=x_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Vr||e.mapping===Yo?(this._cubemapMaterial===null&&(this._cubemapMaterial=y_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=v_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Yw(),this._integrationMaterial=$w());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/V_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Ww)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(z_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Jw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function x_(n,e,t){return new gl(n,{minFilter:Ns,generateMipmaps:e,type:qi,colorSpace:Fa,depthBuffer:t})}function _l(n,e,t){return new Pi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:Qn,blending:kr,depthTest:!1,depthWrite:!1})}function Yw(){return _l("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${z_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function $w(){return _l("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:V_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Jw(){return _l("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Hw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function v_(){return _l("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function y_(){return _l("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Zw(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===lu||d===cu)if(e.has(f)){let _=e.get(f).texture;return a(_,f.mapping)}else{let _=f.image;if(_&&_.height>0){let v=new gl(_.height);return v.fromEquirectangularTexture(n,f),e.set(f,v),f.addEventListener("dispose",c),a(v.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,_=d===lu||d===cu,v=d===Vr||d===Yo;if(_||v){let p=t.get(f),g=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new ju(n)),p=_?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),p.texture;if(p!==void 0)return p.texture;{let x=f.image;return _&&x&&x.height>0||v&&x&&l(x)?(i===null&&(i=new ju(n)),p=_?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),f.addEventListener("dispose",u),p.texture):null}}}return f}function a(f,d){return d===lu?f.mapping=Vr:d===cu&&(f.mapping=Yo),f}function l(f){let d=0,_=6;for(let v=0;v<_;v++)f[v]!==void 0&&d++;return d===_}function c(f){let d=f.target;d.removeEventListener("dispose",c);let _=e.get(d);_!==void 0&&(e.delete(d),_.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let _=t.get(d);_!==void 0&&(t.delete(d),_.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function Kw(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&La("WebGLRenderer: "+i+" extension not supported."),s}}}function jw(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(let p in _.attributes)e.remove(_.attributes[p]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let v=r.get(_);v&&(e.remove(v),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(_){let v=_.attributes;for(let p in v)e.update(v[p],n.ARRAY_BUFFER)}function h(_){let v=_.index,p=_.attributes.position,g=0;if(p===void 0)return;let x=v!==null?v.array.length:p.array.length/3-1,M=p.count>=65535?Fr:Or,b=new M(Math.ceil(x/3)*6,1),y=b.array;if(v!==null){let m=v.array;g=v.version;for(let w=0,I=0;w<x;w+=3){let P=m[w+0],L=m[w+1],N=m[w+2];y[I++]=P,y[I++]=L,y[I++]=L,y[I++]=N,y[I++]=N,y[I++]=P}}else{g=p.version;for(let m=0,w=0;m<x;m+=3){let I=m+0,P=m+1,L=m+2;y[w++]=I,y[w++]=P,y[w++]=P,y[w++]=L,y[w++]=L,y[w++]=I}}b.version=g;let S=r.get(_);S&&e.remove(S),r.set(_,b)}function f(_){let v=r.get(_);if(v){let p=_.index;p!==null&&v.version<p.version&&h(_)}else h(_);return r.get(_)}function d(){for(let _ in s){let v=s[_].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function Qw(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let v=0;for(let p=0;p<d;p++)v+=f[p];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function e1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function t1(n,e,t){let i=new WeakMap,s=new zt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let I=function(){m.dispose(),i.delete(a),a.removeEventListener("dispose",I)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;d===!0&&(M=1),_===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,y=1;b>e.maxTextureSize&&(y=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let S=new Float32Array(b*y*4*h),m=new ka(S,b,y,h);m.type=Ii,m.needsUpdate=!0;let w=M*4;for(let P=0;P<h;P++){let L=p[P],N=g[P],B=x[P],D=b*y*4*P;for(let G=0;G<L.count;G++){let J=G*w;d===!0&&(s.fromBufferAttribute(L,G),S[D+J+0]=s.x,S[D+J+1]=s.y,S[D+J+2]=s.z,S[D+J+3]=0),_===!0&&(s.fromBufferAttribute(N,G),S[D+J+4]=s.x,S[D+J+5]=s.y,S[D+J+6]=s.z,S[D+J+7]=0),v===!0&&(s.fromBufferAttribute(B,G),S[D+J+8]=s.x,S[D+J+9]=s.y,S[D+J+10]=s.z,S[D+J+11]=B.itemSize===4?s.w:1)}}f={count:h,texture:m,size:new tt(b,y)},i.set(a,f),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let _=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function n1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var i1={[id]:"LINEAR_TONE_MAPPING",[sd]:"REINHARD_TONE_MAPPING",[rd]:"CINEON_TONE_MAPPING",[od]:"ACES_FILMIC_TONE_MAPPING",[ld]:"AGX_TONE_MAPPING",[cd]:"NEUTRAL_TONE_MAPPING",[ad]:"CUSTOM_TONE_MAPPING"};function s1(n,e,t,i,s,r){let o=new gi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new ni;u.setAttribute("position",new bn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new bn([0,2,0,0,2,0],2));let h=new Yc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new On(u,h),d=new Ds(-1,1,1,-1,0,1),_=null,v=null,p=!1,g,x=null,M=[],b=!1;this.setSize=function(y,S){o.setSize(y,S),a!==null&&a.setSize(y,S),l!==null&&l.setSize(y,S);for(let m=0;m<M.length;m++){let w=M[m];w.setSize&&w.setSize(y,S)}},this.setEffects=function(y){M=y,b=M.length>0&&M[0].isRenderPass===!0;let S=o.width,m=o.height;M.length>0&&a===null&&(a=new gi(S,m,{type:qi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(S,m,{type:qi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(I=>I.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ls(S,m),r===!0&&(c.format=Os,c.type=Gr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let I=0;I<M.length;I++){let P=M[I];P.setSize&&P.setSize(S,m),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(y,S){if(p||y.toneMapping===cs&&M.length===0)return!1;if(x=S,S!==null){let m=S.width,w=S.height;(o.width!==m||o.height!==w)&&this.setSize(m,w)}return b===!1&&y.setRenderTarget(o),g=y.toneMapping,y.toneMapping=cs,!0},this.hasRenderPass=function(){return b},this.end=function(y,S){y.toneMapping=g,p=!0;let m=o,w=a;for(let I=0;I<M.length;I++){let P=M[I];P.enabled!==!1&&(P.render(y,w,m,S),P.needsSwap!==!1&&(m=w,w=w===a?l:a))}if(_!==y.outputColorSpace||v!==y.toneMapping){_=y.outputColorSpace,v=y.toneMapping,h.defines={},vt.getTransfer(_)===Ct&&(h.defines.SRGB_TRANSFER="");let I=i1[v];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=m.texture,y.setRenderTarget(x),y.render(f,d),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var G_=new ti,H_=new Ls(1,1),W_=new $a(1),X_=new ka,q_=new Gc,Y_=new Ya,b_=[],S_=[],M_=new Float32Array(16),w_=new Float32Array(9),T_=new Float32Array(4);function jo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=b_[s];if(r===void 0&&(r=new Float32Array(s),b_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Mn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Qu(n,e){let t=S_[e];t===void 0&&(t=new Int32Array(e),S_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function r1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function o1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),Mn(t,e)}}function a1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),Mn(t,e)}}function l1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),Mn(t,e)}}function c1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;T_.set(i),n.uniformMatrix2fv(this.addr,!1,T_),Mn(t,i)}}function u1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;w_.set(i),n.uniformMatrix3fv(this.addr,!1,w_),Mn(t,i)}}function h1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,i))return;M_.set(i),n.uniformMatrix4fv(this.addr,!1,M_),Mn(t,i)}}function f1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function d1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),Mn(t,e)}}function p1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),Mn(t,e)}}function m1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),Mn(t,e)}}function g1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function _1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),Mn(t,e)}}function x1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),Mn(t,e)}}function v1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),Mn(t,e)}}function eh(n){return n.version===0&&(n.compareFunction=vd,n.needsUpdate=!0),n}function y1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=eh(H_):r=G_,t.setTexture2D(e||r,s)}function b1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||q_,s)}function S1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=eh(W_):r=Y_,t.setTextureCube(e||r,s)}function M1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||X_,s)}function w1(n){switch(n){case 5126:return r1;case 35664:return o1;case 35665:return a1;case 35666:return l1;case 35674:return c1;case 35675:return u1;case 35676:return h1;case 5124:case 35670:return f1;case 35667:case 35671:return d1;case 35668:case 35672:return p1;case 35669:case 35673:return m1;case 5125:return g1;case 36294:return _1;case 36295:return x1;case 36296:return v1;case 35678:case 36198:case 36298:case 36306:case 35682:return y1;case 35679:case 36299:case 36307:return b1;case 35680:case 36300:case 36308:case 36293:return S1;case 36289:case 36303:case 36311:case 36292:return M1}}function T1(n,e){n.uniform1fv(this.addr,e)}function A1(n,e){let t=jo(e,this.size,2);n.uniform2fv(this.addr,t)}function E1(n,e){let t=jo(e,this.size,3);n.uniform3fv(this.addr,t)}function C1(n,e){let t=jo(e,this.size,4);n.uniform4fv(this.addr,t)}function R1(n,e){let t=jo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function P1(n,e){let t=jo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function I1(n,e){let t=jo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function L1(n,e){n.uniform1iv(this.addr,e)}function D1(n,e){n.uniform2iv(this.addr,e)}function N1(n,e){n.uniform3iv(this.addr,e)}function O1(n,e){n.uniform4iv(this.addr,e)}function F1(n,e){n.uniform1uiv(this.addr,e)}function U1(n,e){n.uniform2uiv(this.addr,e)}function B1(n,e){n.uniform3uiv(this.addr,e)}function k1(n,e){n.uniform4uiv(this.addr,e)}function z1(n,e,t){let i=this.cache,s=e.length,r=Qu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=eh(H_):o=G_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function V1(n,e,t){let i=this.cache,s=e.length,r=Qu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||q_,r[o])}function G1(n,e,t){let i=this.cache,s=e.length,r=Qu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=eh(W_):o=Y_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function H1(n,e,t){let i=this.cache,s=e.length,r=Qu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||X_,r[o])}function W1(n){switch(n){case 5126:return T1;case 35664:return A1;case 35665:return E1;case 35666:return C1;case 35674:return R1;case 35675:return P1;case 35676:return I1;case 5124:case 35670:return L1;case 35667:case 35671:return D1;case 35668:case 35672:return N1;case 35669:case 35673:return O1;case 5125:return F1;case 36294:return U1;case 36295:return B1;case 36296:return k1;case 35678:case 36198:case 36298:case 36306:case 35682:return z1;case 35679:case 36299:case 36307:return V1;case 35680:case 36300:case 36308:case 36293:return G1;case 36289:case 36303:case 36311:case 36292:return H1}}var Id=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=w1(t.type)}},Ld=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=W1(t.type)}},Dd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Rd=/(\w+)(\])?(\[|\.)?/g;function A_(n,e){n.seq.push(e),n.map[e.id]=e}function X1(n,e,t){let i=n.name,s=i.length;for(Rd.lastIndex=0;;){let r=Rd.exec(i),o=Rd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){A_(t,c===void 0?new Id(a,n,e):new Ld(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Dd(a),A_(t,h)),t=h}}}var Zo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);X1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function E_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var q1=37297,Y1=0;function $1(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var C_=new nt;function J1(n){vt._getMatrix(C_,vt.workingColorSpace,n);let e=`mat3( ${C_.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case Ua:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function R_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+$1(n.getShaderSource(e),a)}else return r}function Z1(n,e){let t=J1(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var K1={[id]:"Linear",[sd]:"Reinhard",[rd]:"Cineon",[od]:"ACESFilmic",[ld]:"AgX",[cd]:"Neutral",[ad]:"Custom"};function j1(n,e){let t=K1[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ku=new X;function Q1(){vt.getLuminanceCoefficients(Ku);let n=Ku.x.toFixed(4),e=Ku.y.toFixed(4),t=Ku.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function eT(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ml).join(`
`)}function tT(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function nT(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ml(n){return n!==""}function P_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function I_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var iT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Nd(n){return n.replace(iT,sT)}function sT(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Nd(t)}var rT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function L_(n){return n.replace(rT,oT)}function oT(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function D_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var aT={[ol]:"SHADOWMAP_TYPE_PCF",[Xo]:"SHADOWMAP_TYPE_VSM"};function lT(n){return aT[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var cT={[Yo]:"ENVMAP_MODE_REFRACTION"};function uT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":cT[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var hT={[au]:"ENVMAP_BLENDING_MULTIPLY",[J0]:"ENVMAP_BLENDING_MIX",[Z0]:"ENVMAP_BLENDING_ADD"};function fT(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":hT[n.combine]||"ENVMAP_BLENDING_NONE"}function dT(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=lT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=uT(t),h=fT(t),f=eT(t),d=tT(r),_=s.createProgram(),v,p,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ml).join(`
`),v.length>0&&(v+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ml).join(`
`),p.length>0&&(p+=`
`)):(v=[D_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ml).join(`
`),p=[D_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?ht.tonemapping_pars_fragment:"",t.toneMapping!==cs?j1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,Z1("linearToOutputTexel",t.outputColorSpace),Q1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ml).join(`
`)),o=Nd(o),o=P_(o,t),o=I_(o,t),a=Nd(a),a=P_(a,t),a=I_(a,t),o=L_(o),a=L_(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,p=["#define varying in",t.glslVersion===yd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===yd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=g+v+o,M=g+p+a,b=E_(s,s.VERTEX_SHADER,x),y=E_(s,s.FRAGMENT_SHADER,M);s.attachShader(_,b),s.attachShader(_,y),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function S(P){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(_)||"",N=s.getShaderInfoLog(b)||"",B=s.getShaderInfoLog(y)||"",D=L.trim(),G=N.trim(),J=B.trim(),k=!0,se=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,b,y);else{let Y=R_(s,b,"vertex"),K=R_(s,y,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+D+`
`+Y+`
`+K)}else D!==""?Ye("WebGLProgram: Program Info Log:",D):(G===""||J==="")&&(se=!1);se&&(P.diagnostics={runnable:k,programLog:D,vertexShader:{log:G,prefix:v},fragmentShader:{log:J,prefix:p}})}s.deleteShader(b),s.deleteShader(y),m=new Zo(s,_),w=nT(s,_)}let m;this.getUniforms=function(){return m===void 0&&S(this),m};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let I=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(_,q1)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Y1++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=b,this.fragmentShader=y,this}var pT=0,Od=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Fd(e),t.set(e,i)),i}},Fd=class{constructor(e){this.id=pT++,this.code=e,this.usedTimes=0}};function mT(n){return n===ur||n===fl||n===dl}function gT(n,e,t,i,s,r){let o=new ko,a=new Od,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(m){return l.add(m),m===0?"uv":`uv${m}`}function _(m,w,I,P,L,N){let B=P.fog,D=L.geometry,G=m.isMeshStandardMaterial||m.isMeshLambertMaterial||m.isMeshPhongMaterial?P.environment:null,J=m.isMeshStandardMaterial||m.isMeshLambertMaterial&&!m.envMap||m.isMeshPhongMaterial&&!m.envMap,k=e.get(m.envMap||G,J),se=f[m.type],Y=i.precision;m.precision!==null&&(Y=i.getMaxPrecision(m.precision),Y!==m.precision&&Ye("WebGLProgram.getParameters:",m.precision,"not supported, using",Y,"instead."));let K=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,q=K!==void 0?K.length:0,ie=0;D.morphAttributes.position!==void 0&&(ie=1),D.morphAttributes.normal!==void 0&&(ie=2),D.morphAttributes.color!==void 0&&(ie=3);let ne,j,he,pe;if(se){let Ce=hs[se];ne=Ce.vertexShader,j=Ce.fragmentShader}else{ne=m.vertexShader,j=m.fragmentShader;let Ce=a.getVertexShaderStage(m),lt=a.getFragmentShaderStage(m);a.update(m,Ce,lt),he=Ce.id,pe=lt.id}let _e=n.getRenderTarget(),xe=n.state.buffers.depth.getReversed(),Ge=L.isInstancedMesh===!0,rt=L.isBatchedMesh===!0,He=!!m.map,ft=!!m.matcap,ct=!!k,it=ct&&k.isPMREMTexture===!0,$t=!!m.aoMap,Vt=!!m.lightMap,on=!!m.bumpMap&&m.wireframe===!1,Dt=!!m.normalMap,wn=!!m.displacementMap,bt=!!m.emissiveMap,mn=!!m.metalnessMap,jt=!!m.roughnessMap,an=m.anisotropy>0,V=m.clearcoat>0,Re=m.diffuseRoughness>0,Je=m.dispersion>0,ot=m.retroreflectivity>0,we=m.iridescence>0,Ot=m.sheen>0,Ve=m.transmission>0,qe=an&&!!m.anisotropyMap,O=V&&!!m.clearcoatMap,E=V&&!!m.clearcoatNormalMap,$=V&&!!m.clearcoatRoughnessMap,de=Re&&!!m.diffuseRoughnessMap,ce=we&&!!m.iridescenceMap,ye=we&&!!m.iridescenceThicknessMap,be=Ot&&!!m.sheenColorMap,re=Ot&&!!m.sheenRoughnessMap,ae=!!m.specularMap,ge=!!m.specularColorMap,z=!!m.specularIntensityMap,le=Ve&&!!m.transmissionMap,oe=Ve&&!!m.thicknessMap,Te=!!m.gradientMap,ve=!!m.alphaMap,Me=m.alphaTest>0,We=!!m.alphaHash,Ke=!!m.extensions,fe=cs;m.toneMapped&&(_e===null||_e.isXRRenderTarget===!0)&&(fe=n.toneMapping);let Be=it?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,je={shaderID:se,shaderType:m.type,shaderName:m.name,vertexShader:ne,fragmentShader:j,defines:m.defines,customVertexShaderID:he,customFragmentShaderID:pe,isRawShaderMaterial:m.isRawShaderMaterial===!0,glslVersion:m.glslVersion,precision:Y,batching:rt,batchingColor:rt&&L._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&L.instanceColor!==null,instancingMorph:Ge&&L.morphTexture!==null,outputColorSpace:_e===null?n.outputColorSpace:_e.isXRRenderTarget===!0?_e.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!m.alphaToCoverage,map:He,matcap:ft,envMap:ct,envMapMode:ct&&k.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:$t,lightMap:Vt,bumpMap:on,normalMap:Dt,displacementMap:wn,emissiveMap:bt,normalMapObjectSpace:Dt&&m.normalMapType===Q0,normalMapTangentSpace:Dt&&m.normalMapType===$u,packedNormalMap:Dt&&m.normalMapType===$u&&mT(m.normalMap.format),metalnessMap:mn,roughnessMap:jt,anisotropy:an,anisotropyMap:qe,clearcoat:V,clearcoatMap:O,clearcoatNormalMap:E,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:de,dispersion:Je,retroreflection:ot,iridescence:we,iridescenceMap:ce,iridescenceThicknessMap:ye,sheen:Ot,sheenColorMap:be,sheenRoughnessMap:re,specularMap:ae,specularColorMap:ge,specularIntensityMap:z,transmission:Ve,transmissionMap:le,thicknessMap:oe,gradientMap:Te,opaque:m.transparent===!1&&m.blending===qo&&m.alphaToCoverage===!1,alphaMap:ve,alphaTest:Me,alphaHash:We,combine:m.combine,mapUv:He&&d(m.map.channel),aoMapUv:$t&&d(m.aoMap.channel),lightMapUv:Vt&&d(m.lightMap.channel),bumpMapUv:on&&d(m.bumpMap.channel),normalMapUv:Dt&&d(m.normalMap.channel),displacementMapUv:wn&&d(m.displacementMap.channel),emissiveMapUv:bt&&d(m.emissiveMap.channel),metalnessMapUv:mn&&d(m.metalnessMap.channel),roughnessMapUv:jt&&d(m.roughnessMap.channel),anisotropyMapUv:qe&&d(m.anisotropyMap.channel),clearcoatMapUv:O&&d(m.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(m.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(m.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&d(m.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&d(m.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&d(m.iridescenceThicknessMap.channel),sheenColorMapUv:be&&d(m.sheenColorMap.channel),sheenRoughnessMapUv:re&&d(m.sheenRoughnessMap.channel),specularMapUv:ae&&d(m.specularMap.channel),specularColorMapUv:ge&&d(m.specularColorMap.channel),specularIntensityMapUv:z&&d(m.specularIntensityMap.channel),transmissionMapUv:le&&d(m.transmissionMap.channel),thicknessMapUv:oe&&d(m.thicknessMap.channel),alphaMapUv:ve&&d(m.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Dt||an),vertexNormals:!!D.attributes.normal,vertexColors:m.vertexColors,vertexAlphas:m.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(He||ve),fog:!!B,useFog:m.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:m.wireframe===!1&&(m.flatShading===!0||D.attributes.normal===void 0&&Dt===!1&&(m.isMeshLambertMaterial||m.isMeshPhongMaterial||m.isMeshStandardMaterial||m.isMeshPhysicalMaterial)),sizeAttenuation:m.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:xe,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:q,morphTextureStride:ie,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:N.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:m.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:He&&m.map.isVideoTexture===!0&&vt.getTransfer(m.map.colorSpace)===Ct,decodeVideoTextureEmissive:bt&&m.emissiveMap.isVideoTexture===!0&&vt.getTransfer(m.emissiveMap.colorSpace)===Ct,premultipliedAlpha:m.premultipliedAlpha,doubleSided:m.side===ii,flipSided:m.side===Qn,useDepthPacking:m.depthPacking>=0,depthPacking:m.depthPacking||0,index0AttributeName:m.index0AttributeName,extensionClipCullDistance:Ke&&m.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&m.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:m.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function v(m){let w=[];if(m.shaderID?w.push(m.shaderID):(w.push(m.customVertexShaderID),w.push(m.customFragmentShaderID)),m.defines!==void 0)for(let I in m.defines)w.push(I),w.push(m.defines[I]);return m.isRawShaderMaterial===!1&&(p(w,m),g(w,m),w.push(n.outputColorSpace)),w.push(m.customProgramCacheKey),w.join()}function p(m,w){m.push(w.precision),m.push(w.outputColorSpace),m.push(w.envMapMode),m.push(w.envMapPMREM),m.push(w.envMapMaxLod),m.push(w.envMapSize),m.push(w.mapUv),m.push(w.alphaMapUv),m.push(w.lightMapUv),m.push(w.aoMapUv),m.push(w.bumpMapUv),m.push(w.normalMapUv),m.push(w.displacementMapUv),m.push(w.emissiveMapUv),m.push(w.metalnessMapUv),m.push(w.roughnessMapUv),m.push(w.anisotropyMapUv),m.push(w.clearcoatMapUv),m.push(w.clearcoatNormalMapUv),m.push(w.clearcoatRoughnessMapUv),m.push(w.diffuseRoughnessMapUv),m.push(w.iridescenceMapUv),m.push(w.iridescenceThicknessMapUv),m.push(w.sheenColorMapUv),m.push(w.sheenRoughnessMapUv),m.push(w.specularMapUv),m.push(w.specularColorMapUv),m.push(w.specularIntensityMapUv),m.push(w.transmissionMapUv),m.push(w.thicknessMapUv),m.push(w.combine),m.push(w.fogExp2),m.push(w.sizeAttenuation),m.push(w.morphTargetsCount),m.push(w.numSunLights),m.push(w.numDirLights),m.push(w.numPointLights),m.push(w.numSpotLights),m.push(w.numSpotLightMaps),m.push(w.numHemiLights),m.push(w.numRectAreaLights),m.push(w.numSunLightShadows),m.push(w.numDirLightShadows),m.push(w.numPointLightShadows),m.push(w.numSpotLightShadows),m.push(w.numSpotLightShadowsWithMaps),m.push(w.numLightProbes),m.push(w.numLightProbeGrids),m.push(w.shadowMapType),m.push(w.toneMapping),m.push(w.numClippingPlanes),m.push(w.numClipIntersection),m.push(w.depthPacking)}function g(m,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),m.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),m.push(o.mask)}function x(m){let w=f[m.type],I;if(w){let P=hs[w];I=p_.clone(P.uniforms)}else I=m.uniforms;return I}function M(m,w){let I=u.get(w);return I!==void 0?++I.usedTimes:(I=new dT(n,w,m,s),c.push(I),u.set(w,I)),I}function b(m){if(--m.usedTimes===0){let w=c.indexOf(m);c[w]=c[c.length-1],c.pop(),u.delete(m.cacheKey),m.destroy()}}function y(m){a.remove(m)}function S(){a.dispose()}return{getParameters:_,getProgramCacheKey:v,getUniforms:x,acquireProgram:M,releaseProgram:b,releaseShaderCache:y,programs:c,dispose:S}}function _T(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function xT(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function N_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function O_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,_,v,p,g){let x=n[e];return x===void 0?(x={id:f.id,object:f,geometry:d,material:_,materialVariant:o(f),groupOrder:v,renderOrder:f.renderOrder,z:p,group:g},n[e]=x):(x.id=f.id,x.object=f,x.geometry=d,x.material=_,x.materialVariant=o(f),x.groupOrder=v,x.renderOrder=f.renderOrder,x.z=p,x.group=g),e++,x}function l(f,d,_,v,p,g,x){x.reversedDepth===!0&&(p=-p);let M=a(f,d,_,v,p,g);_.transmission>0?i.push(M):_.transparent===!0?s.push(M):t.push(M)}function c(f,d,_,v,p,g){let x=a(f,d,_,v,p,g);_.transmission>0?i.unshift(x):_.transparent===!0?s.unshift(x):t.unshift(x)}function u(f,d){t.length>1&&t.sort(f||xT),i.length>1&&i.sort(d||N_),s.length>1&&s.sort(d||N_)}function h(){for(let f=e,d=n.length;f<d;f++){let _=n[f];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function vT(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new O_,n.set(i,[o])):s>=r.length?(o=new O_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function yT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new at};break;case"SpotLight":t={position:new X,direction:new X,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function bT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var ST=0;function MT(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function wT(n){let e=new yT,t=bT(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new gt,o=new gt;function a(c){let u=0,h=0,f=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let d=0,_=0,v=0,p=0,g=0,x=0,M=0,b=0,y=0,S=0,m=0,w=0,I=0,P=0;c.sort(MT);for(let N=0,B=c.length;N<B;N++){let D=c[N],G=D.color,J=D.intensity,k=D.distance,se=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===ur?se=D.shadow.map.texture:se=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=G.r*J,h+=G.g*J,f+=G.b*J;else if(D.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(D.sh.coefficients[Y],J);P++}else if(D.isSunLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,q=t.get(D);q.shadowIntensity=K.intensity,q.shadowBias=K.bias,q.shadowNormalBias=K.normalBias,q.shadowRadius=K.radius,q.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[_]=q,i.sunShadowMap[_]=se;let ie=K.getViewportCount();for(let ne=0;ne<ie;ne++)i.sunShadowMatrix[v+ne]=K.getMatrix(ne),i.sunShadowCascade[v+ne]=K._cascadeData[ne];v+=ie,_++}i.sun[d]=Y,d++}else if(D.isDirectionalLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,q=t.get(D);q.shadowIntensity=K.intensity,q.shadowBias=K.bias,q.shadowNormalBias=K.normalBias,q.shadowRadius=K.radius,q.shadowMapSize=K.mapSize,i.directionalShadow[p]=q,i.directionalShadowMap[p]=se,i.directionalShadowMatrix[p]=D.shadow.matrix,y++}i.directional[p]=Y,p++}else if(D.isSpotLight){let Y=e.get(D);Y.position.setFromMatrixPosition(D.matrixWorld),Y.color.copy(G).multiplyScalar(J),Y.distance=k,Y.coneCos=Math.cos(D.angle),Y.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Y.decay=D.decay,i.spot[x]=Y;let K=D.shadow;if(D.map&&(i.spotLightMap[w]=D.map,w++,K.updateMatrices(D),D.castShadow&&I++),i.spotLightMatrix[x]=K.matrix,D.castShadow){let q=t.get(D);q.shadowIntensity=K.intensity,q.shadowBias=K.bias,q.shadowNormalBias=K.normalBias,q.shadowRadius=K.radius,q.shadowMapSize=K.mapSize,i.spotShadow[x]=q,i.spotShadowMap[x]=se,m++}x++}else if(D.isRectAreaLight){let Y=e.get(D);Y.color.copy(G).multiplyScalar(J),Y.halfWidth.set(D.width*.5,0,0),Y.halfHeight.set(0,D.height*.5,0),i.rectArea[M]=Y,M++}else if(D.isPointLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),Y.distance=D.distance,Y.decay=D.decay,D.castShadow){let K=D.shadow,q=t.get(D);q.shadowIntensity=K.intensity,q.shadowBias=K.bias,q.shadowNormalBias=K.normalBias,q.shadowRadius=K.radius,q.shadowMapSize=K.mapSize,q.shadowCameraNear=K.camera.near,q.shadowCameraFar=K.camera.far,i.pointShadow[g]=q,i.pointShadowMap[g]=se,i.pointShadowMatrix[g]=D.shadow.matrix,S++}i.point[g]=Y,g++}else if(D.isHemisphereLight){let Y=e.get(D);Y.skyColor.copy(D.color).multiplyScalar(J),Y.groundColor.copy(D.groundColor).multiplyScalar(J),i.hemi[b]=Y,b++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let L=i.hash;(L.sunLength!==d||L.directionalLength!==p||L.pointLength!==g||L.spotLength!==x||L.rectAreaLength!==M||L.hemiLength!==b||L.numSunShadows!==_||L.numDirectionalShadows!==y||L.numPointShadows!==S||L.numSpotShadows!==m||L.numSpotMaps!==w||L.numLightProbes!==P)&&(i.sun.length=d,i.directional.length=p,i.spot.length=x,i.rectArea.length=M,i.point.length=g,i.hemi.length=b,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.directionalShadowMatrix.length=y,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=m,i.spotShadowMap.length=m,i.spotLightMatrix.length=m+w-I,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=P,L.sunLength=d,L.directionalLength=p,L.pointLength=g,L.spotLength=x,L.rectAreaLength=M,L.hemiLength=b,L.numSunShadows=_,L.numDirectionalShadows=y,L.numPointShadows=S,L.numSpotShadows=m,L.numSpotMaps=w,L.numLightProbes=P,i.version=ST++)}function l(c,u){let h=0,f=0,d=0,_=0,v=0,p=0,g=u.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let b=c[x];if(b.isSunLight){let y=i.sun[h];y.direction.setFromMatrixPosition(b.matrixWorld),y.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let y=i.directional[f];y.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),f++}else if(b.isSpotLight){let y=i.spot[_];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(g),y.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),_++}else if(b.isRectAreaLight){let y=i.rectArea[v];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),y.halfWidth.set(b.width*.5,0,0),y.halfHeight.set(0,b.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let y=i.point[d];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(g),d++}else if(b.isHemisphereLight){let y=i.hemi[p];y.direction.setFromMatrixPosition(b.matrixWorld),y.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function F_(n){let e=new wT(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function TT(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new F_(n),e.set(s,[a])):r>=o.length?(a=new F_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var AT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ET=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,CT=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],RT=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],U_=new gt,pl=new X,Pd=new X;function PT(n,e,t){let i=new ir,s=new tt,r=new tt,o=new zt,a=new $c,l=new Jc,c={},u=t.maxTextureSize,h={[cr]:Qn,[Qn]:cr,[ii]:ii},f=new Pi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:AT,fragmentShader:ET}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let _=new ni;_.setAttribute("position",new Zt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new On(_,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ol;let g=this.type;this.render=function(S,m,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||S.length===0)return;this.type===P0&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ol);let I=n.getRenderTarget(),P=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),N=n.state;N.setBlending(kr),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let B=g!==this.type;B&&m.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(G=>G.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,G=S.length;D<G;D++){let J=S[D],k=J.shadow;if(k===void 0){Ye("WebGLShadowMap:",J,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let se=k.getFrameExtents();s.multiply(se),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/se.x),s.x=r.x*se.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/se.y),s.y=r.y*se.y,k.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=Y,k.map===null||B===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===Xo){if(J.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new gi(s.x,s.y,{format:ur,type:qi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),k.map.texture.name=J.name+".shadowMap",k.map.depthTexture=new Ls(s.x,s.y,Ii),k.map.depthTexture.name=J.name+".shadowMapDepth",k.map.depthTexture.format=Es,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Nn,k.map.depthTexture.magFilter=Nn}else J.isPointLight?(k.map=new gl(s.x),k.map.depthTexture=new $a(s.x,Xi)):(k.map=new gi(s.x,s.y),k.map.depthTexture=new Ls(s.x,s.y,Xi)),k.map.depthTexture.name=J.name+".shadowMap",k.map.depthTexture.format=Es,this.type===ol?(k.map.depthTexture.compareFunction=Y?xd:_d,k.map.depthTexture.minFilter=jn,k.map.depthTexture.magFilter=jn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Nn,k.map.depthTexture.magFilter=Nn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let K=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();J.isPointLight!==!0&&k.updateMatrices(J,w);let q=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:w.layers;for(let ie=0;ie<K;ie++){let ne=k.getCamera(ie);if(J.isPointLight){let j=k.camera,he=k.matrix,pe=J.distance||j.far;pe!==j.far&&(j.far=pe,j.updateProjectionMatrix()),pl.setFromMatrixPosition(J.matrixWorld),j.position.copy(pl),Pd.copy(j.position),Pd.add(CT[ie]),j.up.copy(RT[ie]),j.lookAt(Pd),j.updateMatrixWorld(),he.makeTranslation(-pl.x,-pl.y,-pl.z),U_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),k._frustum.setFromProjectionMatrix(U_,j.coordinateSystem,j.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,ie),n.clear();else{ie===0&&(n.setRenderTarget(k.map),n.clear());let j=k.getViewport(ie);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),N.viewport(o)}i=k.getFrustum(ie),b(m,w,ne,J,q,this.type)}k.isPointLightShadow!==!0&&this.type===Xo&&x(k,w),k.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(I,P,L)};function x(S,m){let w=e.update(v);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new gi(s.x,s.y,{format:ur,type:qi}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(m,null,w,f,v,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(m,null,w,d,v,null)}function M(S,m,w,I){let P=null,L=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(L!==void 0)P=L;else if(P=w.isPointLight===!0?l:a,n.localClippingEnabled&&m.clipShadows===!0&&Array.isArray(m.clippingPlanes)&&m.clippingPlanes.length!==0||m.displacementMap&&m.displacementScale!==0||m.alphaMap&&m.alphaTest>0||m.map&&m.alphaTest>0||m.alphaToCoverage===!0){let N=P.uuid,B=m.uuid,D=c[N];D===void 0&&(D={},c[N]=D);let G=D[B];G===void 0&&(G=P.clone(),D[B]=G,m.addEventListener("dispose",y)),P=G}if(P.visible=m.visible,P.wireframe=m.wireframe,I===Xo?P.side=m.shadowSide!==null?m.shadowSide:m.side:P.side=m.shadowSide!==null?m.shadowSide:h[m.side],P.alphaMap=m.alphaMap,P.alphaTest=m.alphaToCoverage===!0?.5:m.alphaTest,P.map=m.map,P.clipShadows=m.clipShadows,P.clippingPlanes=m.clippingPlanes,P.clipIntersection=m.clipIntersection,P.displacementMap=m.displacementMap,P.displacementScale=m.displacementScale,P.displacementBias=m.displacementBias,P.wireframeLinewidth=m.wireframeLinewidth,P.linewidth=m.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let N=n.properties.get(P);N.light=w}return P}function b(S,m,w,I,P,L){if(S.visible===!1)return;if(S.layers.test(P)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&L===Xo)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let D=e.update(S),G=S.material;if(Array.isArray(G)){let J=D.groups;for(let k=0,se=J.length;k<se;k++){let Y=J[k],K=G[Y.materialIndex];if(K&&K.visible){let q=M(S,K,I,L);S.onBeforeShadow(n,S,m,w,D,q,Y),n.renderBufferDirect(w,null,D,q,S,Y),S.onAfterShadow(n,S,m,w,D,q,Y)}}}else if(G.visible){let J=M(S,G,I,L);S.onBeforeShadow(n,S,m,w,D,J,null),n.renderBufferDirect(w,null,D,J,S,null),S.onAfterShadow(n,S,m,w,D,J,null)}}let B=S.children;for(let D=0,G=B.length;D<G;D++)b(B[D],m,w,I,P,L)}function y(S){S.target.removeEventListener("dispose",y);for(let w in c){let I=c[w],P=S.target.uuid;P in I&&(I[P].dispose(),delete I[P])}}}function IT(n,e){function t(){let z=!1,le=new zt,oe=null,Te=new zt(0,0,0,0);return{setMask:function(ve){oe!==ve&&!z&&(n.colorMask(ve,ve,ve,ve),oe=ve)},setLocked:function(ve){z=ve},setClear:function(ve,Me,We,Ke,fe){fe===!0&&(ve*=Ke,Me*=Ke,We*=Ke),le.set(ve,Me,We,Ke),Te.equals(le)===!1&&(n.clearColor(ve,Me,We,Ke),Te.copy(le))},reset:function(){z=!1,oe=null,Te.set(-1,0,0,0)}}}function i(){let z=!1,le=!1,oe=null,Te=null,ve=null;return{setReversed:function(Me){if(le!==Me){let We=e.get("EXT_clip_control");Me?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),le=Me;let Ke=ve;ve=null,this.setClear(Ke)}},getReversed:function(){return le},setTest:function(Me){Me?xe(n.DEPTH_TEST):Ge(n.DEPTH_TEST)},setMask:function(Me){oe!==Me&&!z&&(n.depthMask(Me),oe=Me)},setFunc:function(Me){if(le&&(Me=u_[Me]),Te!==Me){switch(Me){case Pc:n.depthFunc(n.NEVER);break;case Ic:n.depthFunc(n.ALWAYS);break;case Lc:n.depthFunc(n.LESS);break;case No:n.depthFunc(n.LEQUAL);break;case Dc:n.depthFunc(n.EQUAL);break;case Nc:n.depthFunc(n.GEQUAL);break;case Oc:n.depthFunc(n.GREATER);break;case Fc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Me}},setLocked:function(Me){z=Me},setClear:function(Me){ve!==Me&&(ve=Me,le&&(Me=1-Me),n.clearDepth(Me))},reset:function(){z=!1,oe=null,Te=null,ve=null,le=!1}}}function s(){let z=!1,le=null,oe=null,Te=null,ve=null,Me=null,We=null,Ke=null,fe=null;return{setTest:function(Be){z||(Be?xe(n.STENCIL_TEST):Ge(n.STENCIL_TEST))},setMask:function(Be){le!==Be&&!z&&(n.stencilMask(Be),le=Be)},setFunc:function(Be,je,Ce){(oe!==Be||Te!==je||ve!==Ce)&&(n.stencilFunc(Be,je,Ce),oe=Be,Te=je,ve=Ce)},setOp:function(Be,je,Ce){(Me!==Be||We!==je||Ke!==Ce)&&(n.stencilOp(Be,je,Ce),Me=Be,We=je,Ke=Ce)},setLocked:function(Be){z=Be},setClear:function(Be){fe!==Be&&(n.clearStencil(Be),fe=Be)},reset:function(){z=!1,le=null,oe=null,Te=null,ve=null,Me=null,We=null,Ke=null,fe=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,_=[],v=null,p=!1,g=null,x=null,M=null,b=null,y=null,S=null,m=null,w=new at(0,0,0),I=0,P=!1,L=null,N=null,B=null,D=null,G=null,J=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,se=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec(Y)[1]),k=se>=1):Y.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),k=se>=2);let K=null,q={},ie=n.getParameter(n.SCISSOR_BOX),ne=n.getParameter(n.VIEWPORT),j=new zt().fromArray(ie),he=new zt().fromArray(ne);function pe(z,le,oe,Te){let ve=new Uint8Array(4),Me=n.createTexture();n.bindTexture(z,Me),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<oe;We++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(le,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,ve):n.texImage2D(le+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ve);return Me}let _e={};_e[n.TEXTURE_2D]=pe(n.TEXTURE_2D,n.TEXTURE_2D,1),_e[n.TEXTURE_CUBE_MAP]=pe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),_e[n.TEXTURE_2D_ARRAY]=pe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),_e[n.TEXTURE_3D]=pe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(n.DEPTH_TEST),o.setFunc(No),on(!1),Dt(Kf),xe(n.CULL_FACE),$t(kr);function xe(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function Ge(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function rt(z,le){return f[z]!==le?(n.bindFramebuffer(z,le),f[z]=le,z===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=le),z===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=le),!0):!1}function He(z,le){let oe=_,Te=!1;if(z){oe=d.get(le),oe===void 0&&(oe=[],d.set(le,oe));let ve=z.textures;if(oe.length!==ve.length||oe[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,We=ve.length;Me<We;Me++)oe[Me]=n.COLOR_ATTACHMENT0+Me;oe.length=ve.length,Te=!0}}else oe[0]!==n.BACK&&(oe[0]=n.BACK,Te=!0);Te&&n.drawBuffers(oe)}function ft(z){return v!==z?(n.useProgram(z),v=z,!0):!1}let ct={[zr]:n.FUNC_ADD,[L0]:n.FUNC_SUBTRACT,[D0]:n.FUNC_REVERSE_SUBTRACT};ct[N0]=n.MIN,ct[O0]=n.MAX;let it={[F0]:n.ZERO,[U0]:n.ONE,[B0]:n.SRC_COLOR,[td]:n.SRC_ALPHA,[W0]:n.SRC_ALPHA_SATURATE,[G0]:n.DST_COLOR,[z0]:n.DST_ALPHA,[k0]:n.ONE_MINUS_SRC_COLOR,[nd]:n.ONE_MINUS_SRC_ALPHA,[H0]:n.ONE_MINUS_DST_COLOR,[V0]:n.ONE_MINUS_DST_ALPHA,[X0]:n.CONSTANT_COLOR,[q0]:n.ONE_MINUS_CONSTANT_COLOR,[Y0]:n.CONSTANT_ALPHA,[$0]:n.ONE_MINUS_CONSTANT_ALPHA};function $t(z,le,oe,Te,ve,Me,We,Ke,fe,Be){if(z===kr){p===!0&&(Ge(n.BLEND),p=!1);return}if(p===!1&&(xe(n.BLEND),p=!0),z!==I0){if(z!==g||Be!==P){if((x!==zr||y!==zr)&&(n.blendEquation(n.FUNC_ADD),x=zr,y=zr),Be)switch(z){case qo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case jf:n.blendFunc(n.ONE,n.ONE);break;case Qf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ed:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",z);break}else switch(z){case qo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case jf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Qf:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ed:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",z);break}M=null,b=null,S=null,m=null,w.set(0,0,0),I=0,g=z,P=Be}return}ve=ve||le,Me=Me||oe,We=We||Te,(le!==x||ve!==y)&&(n.blendEquationSeparate(ct[le],ct[ve]),x=le,y=ve),(oe!==M||Te!==b||Me!==S||We!==m)&&(n.blendFuncSeparate(it[oe],it[Te],it[Me],it[We]),M=oe,b=Te,S=Me,m=We),(Ke.equals(w)===!1||fe!==I)&&(n.blendColor(Ke.r,Ke.g,Ke.b,fe),w.copy(Ke),I=fe),g=z,P=!1}function Vt(z,le){z.side===ii?Ge(n.CULL_FACE):xe(n.CULL_FACE);let oe=z.side===Qn;le&&(oe=!oe),on(oe),z.blending===qo&&z.transparent===!1?$t(kr):$t(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Te=z.stencilWrite;a.setTest(Te),Te&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),bt(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?xe(n.SAMPLE_ALPHA_TO_COVERAGE):Ge(n.SAMPLE_ALPHA_TO_COVERAGE)}function on(z){L!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),L=z)}function Dt(z){z!==C0?(xe(n.CULL_FACE),z!==N&&(z===Kf?n.cullFace(n.BACK):z===R0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ge(n.CULL_FACE),N=z}function wn(z){z!==B&&(k&&n.lineWidth(z),B=z)}function bt(z,le,oe){z?(xe(n.POLYGON_OFFSET_FILL),(D!==le||G!==oe)&&(D=le,G=oe,o.getReversed()&&(le=-le,oe=-oe),n.polygonOffset(le,oe))):Ge(n.POLYGON_OFFSET_FILL)}function mn(z){z?xe(n.SCISSOR_TEST):Ge(n.SCISSOR_TEST)}function jt(z){z===void 0&&(z=n.TEXTURE0+J-1),K!==z&&(n.activeTexture(z),K=z)}function an(z,le,oe){oe===void 0&&(K===null?oe=n.TEXTURE0+J-1:oe=K);let Te=q[oe];Te===void 0&&(Te={type:void 0,texture:void 0},q[oe]=Te),(Te.type!==z||Te.texture!==le)&&(K!==oe&&(n.activeTexture(oe),K=oe),n.bindTexture(z,le||_e[z]),Te.type=z,Te.texture=le)}function V(){let z=q[K];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function ot(){try{n.texSubImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function we(){try{n.texSubImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function qe(){try{n.texStorage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function O(){try{n.texStorage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function E(){try{n.texImage2D(...arguments)}catch(z){Qe("WebGLState:",z)}}function $(){try{n.texImage3D(...arguments)}catch(z){Qe("WebGLState:",z)}}function de(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function ce(z,le){h[z]!==le&&(n.pixelStorei(z,le),h[z]=le)}function ye(z){j.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),j.copy(z))}function be(z){he.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),he.copy(z))}function re(z,le){let oe=c.get(le);oe===void 0&&(oe=new WeakMap,c.set(le,oe));let Te=oe.get(z);Te===void 0&&(Te=n.getUniformBlockIndex(le,z.name),n.uniformBlockBinding(le,Te,Te),oe.set(z,Te))}function ae(z,le,oe){let ve=c.get(le).get(z);l[ve]!==oe&&(n.bindBufferBase(n.UNIFORM_BUFFER,ve,oe),l[ve]=oe)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,q={},f={},l={},d=new WeakMap,_=[],v=null,p=!1,g=null,x=null,M=null,b=null,y=null,S=null,m=null,w=new at(0,0,0),I=0,P=!1,L=null,N=null,B=null,D=null,G=null,j.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:Ge,bindFramebuffer:rt,drawBuffers:He,useProgram:ft,setBlending:$t,setMaterial:Vt,setFlipSided:on,setCullFace:Dt,setLineWidth:wn,setPolygonOffset:bt,setScissorTest:mn,activeTexture:jt,bindTexture:an,unbindTexture:V,compressedTexImage2D:Re,compressedTexImage3D:Je,texImage2D:E,texImage3D:$,pixelStorei:ce,getParameter:de,updateUBOMapping:re,uniformBlockBinding:ae,texStorage2D:qe,texStorage3D:O,texSubImage2D:ot,texSubImage3D:we,compressedTexSubImage2D:Ot,compressedTexSubImage3D:Ve,scissor:ye,viewport:be,reset:ge}}function LT(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,u=new WeakMap,h=new Set,f,d=new WeakMap,_=new Set,v=new FinalizationRegistry(O=>_.delete(O)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,E){return p?new OffscreenCanvas(O,E):Ba("canvas")}function x(O,E,$){let de=1,ce=qe(O);if((ce.width>$||ce.height>$)&&(de=$/Math.max(ce.width,ce.height)),de<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let ye=Math.floor(de*ce.width),be=Math.floor(de*ce.height);f===void 0&&(f=g(ye,be));let re=E?g(ye,be):f;return re.width=ye,re.height=be,re.getContext("2d").drawImage(O,0,0,ye,be),Ye("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+ye+"x"+be+")."),re}else return"data"in O&&Ye("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),O;return O}function M(O){return O.generateMipmaps}function b(O){n.generateMipmap(O)}function y(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(O,E,$,de,ce,ye=!1){if(O!==null){if(n[O]!==void 0)return n[O];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let be;de&&(be=e.get("EXT_texture_norm16"),be||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let re=E;if(E===n.RED&&($===n.FLOAT&&(re=n.R32F),$===n.HALF_FLOAT&&(re=n.R16F),$===n.UNSIGNED_BYTE&&(re=n.R8),$===n.UNSIGNED_SHORT&&be&&(re=be.R16_EXT),$===n.SHORT&&be&&(re=be.R16_SNORM_EXT)),E===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(re=n.R8UI),$===n.UNSIGNED_SHORT&&(re=n.R16UI),$===n.UNSIGNED_INT&&(re=n.R32UI),$===n.BYTE&&(re=n.R8I),$===n.SHORT&&(re=n.R16I),$===n.INT&&(re=n.R32I)),E===n.RG&&($===n.FLOAT&&(re=n.RG32F),$===n.HALF_FLOAT&&(re=n.RG16F),$===n.UNSIGNED_BYTE&&(re=n.RG8),$===n.UNSIGNED_SHORT&&be&&(re=be.RG16_EXT),$===n.SHORT&&be&&(re=be.RG16_SNORM_EXT)),E===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(re=n.RG8UI),$===n.UNSIGNED_SHORT&&(re=n.RG16UI),$===n.UNSIGNED_INT&&(re=n.RG32UI),$===n.BYTE&&(re=n.RG8I),$===n.SHORT&&(re=n.RG16I),$===n.INT&&(re=n.RG32I)),E===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(re=n.RGB8UI),$===n.UNSIGNED_SHORT&&(re=n.RGB16UI),$===n.UNSIGNED_INT&&(re=n.RGB32UI),$===n.BYTE&&(re=n.RGB8I),$===n.SHORT&&(re=n.RGB16I),$===n.INT&&(re=n.RGB32I)),E===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(re=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(re=n.RGBA16UI),$===n.UNSIGNED_INT&&(re=n.RGBA32UI),$===n.BYTE&&(re=n.RGBA8I),$===n.SHORT&&(re=n.RGBA16I),$===n.INT&&(re=n.RGBA32I)),E===n.RGB&&($===n.UNSIGNED_SHORT&&be&&(re=be.RGB16_EXT),$===n.SHORT&&be&&(re=be.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(re=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(re=n.R11F_G11F_B10F)),E===n.RGBA){let ae=ye?Ua:vt.getTransfer(ce);$===n.FLOAT&&(re=n.RGBA32F),$===n.HALF_FLOAT&&(re=n.RGBA16F),$===n.UNSIGNED_BYTE&&(re=ae===Ct?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&be&&(re=be.RGBA16_EXT),$===n.SHORT&&be&&(re=be.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(re=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(re=n.RGB5_A1)}return(re===n.R16F||re===n.R32F||re===n.RG16F||re===n.RG32F||re===n.RGBA16F||re===n.RGBA32F)&&e.get("EXT_color_buffer_float"),re}function m(O,E){let $;return O?E===null||E===Xi||E===Gr?$=n.DEPTH24_STENCIL8:E===Ii?$=n.DEPTH32F_STENCIL8:E===$o&&($=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Xi||E===Gr?$=n.DEPTH_COMPONENT24:E===Ii?$=n.DEPTH_COMPONENT32F:E===$o&&($=n.DEPTH_COMPONENT16),$}function w(O,E){return M(O)===!0||O.isFramebufferTexture&&O.minFilter!==Nn&&O.minFilter!==jn?Math.log2(Math.max(E.width,E.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?E.mipmaps.length:1}function I(O){let E=new WeakRef(O);i.get(O).__ref=E,_.add(E),v.register(O,E,E)}function P(O){let E=i.get(O).__ref;E!==void 0&&(_.delete(E),v.unregister(E))}function L(O){B(O.target)}function N(O){D(O.target)}function B(O){O.removeEventListener("dispose",L),P(O),J(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function D(O){O.removeEventListener("dispose",N),P(O),se(O)}function G(){for(let O of _){let E=O.deref();E!==void 0&&(E.isRenderTarget===!0?D(E):B(E))}_.clear(),h.clear()}function J(O){let E=i.get(O);if(E.__webglInit===void 0)return;let $=O.source,de=d.get($);if(de){let ce=de[E.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&k(O),Object.keys(de).length===0&&d.delete($)}i.remove(O)}function k(O){let E=i.get(O);n.deleteTexture(E.__webglTexture);let $=O.source,de=d.get($);delete de[E.__cacheKey],o.memory.textures--}function se(O){let E=i.get(O);E.__depthDisposeCallback&&E.__depthDisposeCallback();let $=O.depthTexture;if($&&$.renderTarget===O&&B($),O.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(E.__webglFramebuffer[ce]))for(let ye=0;ye<E.__webglFramebuffer[ce].length;ye++)n.deleteFramebuffer(E.__webglFramebuffer[ce][ye]);else n.deleteFramebuffer(E.__webglFramebuffer[ce]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[ce])}else{if(Array.isArray(E.__webglFramebuffer))for(let ce=0;ce<E.__webglFramebuffer.length;ce++)n.deleteFramebuffer(E.__webglFramebuffer[ce]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ce=0;ce<E.__webglColorRenderbuffer.length;ce++)E.__webglColorRenderbuffer[ce]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[ce]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let de=O.textures;for(let ce=0,ye=de.length;ce<ye;ce++){let be=i.get(de[ce]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(de[ce])}i.remove(O)}let Y=0;function K(){Y=0}function q(){return Y}function ie(O){Y=O}function ne(){let O=Y;return O>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function j(O){let E=[];return E.push(O.wrapS),E.push(O.wrapT),E.push(O.wrapR||0),E.push(O.magFilter),E.push(O.minFilter),E.push(O.anisotropy),E.push(O.internalFormat),E.push(O.format),E.push(O.type),E.push(O.generateMipmaps),E.push(O.mipmapsAutoUpdate),E.push(O.premultiplyAlpha),E.push(O.flipY),E.push(O.unpackAlignment),E.push(O.colorSpace),E.join()}function he(O,E){let $=i.get(O);if(O.isVideoTexture&&Ot(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&$.__version!==O.version){let de=O.image;if(de===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt($,O,E);return}}else O.isExternalTexture&&($.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+E)}function pe(O,E){let $=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&$.__version!==O.version){Vt($,O,E);return}else O.isExternalTexture&&($.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+E)}function _e(O,E){let $=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&$.__version!==O.version){Vt($,O,E);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+E)}function xe(O,E){let $=i.get(O);if(O.version>0&&$.__version!==O.version){on($,O,E);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+E)}let Ge={[Uc]:n.REPEAT,[os]:n.CLAMP_TO_EDGE,[Bc]:n.MIRRORED_REPEAT},rt={[Nn]:n.NEAREST,[K0]:n.NEAREST_MIPMAP_NEAREST,[al]:n.NEAREST_MIPMAP_LINEAR,[jn]:n.LINEAR,[uu]:n.LINEAR_MIPMAP_NEAREST,[Ns]:n.LINEAR_MIPMAP_LINEAR},He={[t_]:n.NEVER,[vd]:n.ALWAYS,[n_]:n.LESS,[_d]:n.LEQUAL,[i_]:n.EQUAL,[xd]:n.GEQUAL,[s_]:n.GREATER,[r_]:n.NOTEQUAL};function ft(O,E){if(E.type===Ii&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===jn||E.magFilter===uu||E.magFilter===al||E.magFilter===Ns||E.minFilter===jn||E.minFilter===uu||E.minFilter===al||E.minFilter===Ns)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Ge[E.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Ge[E.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Ge[E.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,rt[E.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,rt[E.minFilter]),E.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,He[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Nn||E.minFilter!==al&&E.minFilter!==Ns||E.type===Ii&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(O,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ct(O,E){let $=!1;O.__webglInit===void 0&&(O.__webglInit=!0,E.addEventListener("dispose",L),I(E));let de=E.source,ce=d.get(de);ce===void 0&&(ce={},d.set(de,ce));let ye=j(E);if(ye!==O.__cacheKey){ce[ye]===void 0&&(ce[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ce[ye].usedTimes++;let be=ce[O.__cacheKey];be!==void 0&&(ce[O.__cacheKey].usedTimes--,be.usedTimes===0&&k(E)),O.__cacheKey=ye,O.__webglTexture=ce[ye].texture}return $}function it(O,E,$){return Math.floor(Math.floor(O/$)/E)}function $t(O,E,$,de){let ye=O.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,$,de,E.data);else{ye.sort((z,le)=>z.start-le.start);let be=0;for(let z=1;z<ye.length;z++){let le=ye[be],oe=ye[z],Te=le.start+le.count,ve=it(oe.start,E.width,4),Me=it(le.start,E.width,4);oe.start<=Te+1&&ve===Me&&it(oe.start+oe.count-1,E.width,4)===ve?le.count=Math.max(le.count,oe.start+oe.count-le.start):(++be,ye[be]=oe)}ye.length=be+1;let re=t.getParameter(n.UNPACK_ROW_LENGTH),ae=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let z=0,le=ye.length;z<le;z++){let oe=ye[z],Te=Math.floor(oe.start/4),ve=Math.ceil(oe.count/4),Me=Te%E.width,We=Math.floor(Te/E.width),Ke=ve,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Me,We,Ke,fe,$,de,E.data)}O.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,re),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Vt(O,E,$){let de=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(de=n.TEXTURE_3D);let ce=ct(O,E),ye=E.source;t.bindTexture(de,O.__webglTexture,n.TEXTURE0+$);let be=i.get(ye);if(ye.version!==be.__version||ce===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let fe=vt.getPrimaries(vt.workingColorSpace),Be=E.colorSpace===Fs?null:vt.getPrimaries(E.colorSpace),je=E.colorSpace===Fs||fe===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let ae=x(E.image,!1,s.maxTextureSize);ae=Ve(E,ae);let ge=r.convert(E.format,E.colorSpace),z=r.convert(E.type),le=S(E.internalFormat,ge,z,E.normalized,E.colorSpace,E.isVideoTexture);ft(de,E);let oe,Te=E.mipmaps,ve=E.isVideoTexture!==!0,Me=be.__version===void 0||ce===!0,We=ye.dataReady,Ke=w(E,ae);if(E.isDepthTexture)le=m(E.format===Os,E.type),Me&&(ve?t.texStorage2D(n.TEXTURE_2D,1,le,ae.width,ae.height):t.texImage2D(n.TEXTURE_2D,0,le,ae.width,ae.height,0,ge,z,null));else if(E.isDataTexture)if(Te.length>0){ve&&Me&&t.texStorage2D(n.TEXTURE_2D,Ke,le,Te[0].width,Te[0].height);for(let fe=0,Be=Te.length;fe<Be;fe++)oe=Te[fe],ve?We&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,ge,z,oe.data):t.texImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,ge,z,oe.data);E.generateMipmaps=!1}else ve?(Me&&t.texStorage2D(n.TEXTURE_2D,Ke,le,ae.width,ae.height),We&&$t(E,ae,ge,z)):t.texImage2D(n.TEXTURE_2D,0,le,ae.width,ae.height,0,ge,z,ae.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){ve&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,le,Te[0].width,Te[0].height,ae.depth);for(let fe=0,Be=Te.length;fe<Be;fe++)if(oe=Te[fe],E.format!==Yi)if(ge!==null)if(ve){if(We)if(E.layerUpdates.size>0){let je=Cd(oe.width,oe.height,E.format,E.type);for(let Ce of E.layerUpdates){let lt=oe.data.subarray(Ce*je/oe.data.BYTES_PER_ELEMENT,(Ce+1)*je/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Ce,oe.width,oe.height,1,ge,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,oe.width,oe.height,ae.depth,ge,oe.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,le,oe.width,oe.height,ae.depth,0,oe.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,oe.width,oe.height,ae.depth,ge,z,oe.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,le,oe.width,oe.height,ae.depth,0,ge,z,oe.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{ve&&Me&&t.texStorage2D(n.TEXTURE_2D,Ke,le,Te[0].width,Te[0].height);for(let fe=0,Be=Te.length;fe<Be;fe++)oe=Te[fe],E.format!==Yi?ge!==null?ve?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,ge,oe.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,oe.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?We&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,oe.width,oe.height,ge,z,oe.data):t.texImage2D(n.TEXTURE_2D,fe,le,oe.width,oe.height,0,ge,z,oe.data)}else if(E.isDataArrayTexture)if(ve){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,le,ae.width,ae.height,ae.depth),We)if(E.layerUpdates.size>0){let fe=Cd(ae.width,ae.height,E.format,E.type);for(let Be of E.layerUpdates){let je=ae.data.subarray(Be*fe/ae.data.BYTES_PER_ELEMENT,(Be+1)*fe/ae.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ae.width,ae.height,1,ge,z,je)}E.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ae.width,ae.height,ae.depth,ge,z,ae.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,le,ae.width,ae.height,ae.depth,0,ge,z,ae.data);else if(E.isData3DTexture)ve?(Me&&t.texStorage3D(n.TEXTURE_3D,Ke,le,ae.width,ae.height,ae.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ae.width,ae.height,ae.depth,ge,z,ae.data)):t.texImage3D(n.TEXTURE_3D,0,le,ae.width,ae.height,ae.depth,0,ge,z,ae.data);else if(E.isFramebufferTexture){if(Me)if(ve)t.texStorage2D(n.TEXTURE_2D,Ke,le,ae.width,ae.height);else{let fe=ae.width,Be=ae.height;for(let je=0;je<Ke;je++)t.texImage2D(n.TEXTURE_2D,je,le,fe,Be,0,ge,z,null),fe>>=1,Be>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),ae.parentNode!==fe){fe.appendChild(ae),h.add(E),fe.onpaint=Be=>{let je=Be.changedElements;for(let Ce of h)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ae);else{let je=n.RGBA,Ce=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,lt,ae)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ve&&Me){let fe=qe(Te[0]);t.texStorage2D(n.TEXTURE_2D,Ke,le,fe.width,fe.height)}for(let fe=0,Be=Te.length;fe<Be;fe++)oe=Te[fe],ve?We&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,ge,z,oe):t.texImage2D(n.TEXTURE_2D,fe,le,ge,z,oe);E.generateMipmaps=!1}else if(ve){if(Me){let fe=qe(ae);t.texStorage2D(n.TEXTURE_2D,Ke,le,fe.width,fe.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,z,ae)}else t.texImage2D(n.TEXTURE_2D,0,le,ge,z,ae);M(E)&&E.mipmapsAutoUpdate===!0&&b(de),be.__version=ye.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function on(O,E,$){if(E.image.length!==6)return;let de=ct(O,E),ce=E.source;t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+$);let ye=i.get(ce);if(ce.version!==ye.__version||de===!0){t.activeTexture(n.TEXTURE0+$);let be=vt.getPrimaries(vt.workingColorSpace),re=E.colorSpace===Fs?null:vt.getPrimaries(E.colorSpace),ae=E.colorSpace===Fs||be===re?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae);let ge=E.isCompressedTexture||E.image[0].isCompressedTexture,z=E.image[0]&&E.image[0].isDataTexture,le=[];for(let Ce=0;Ce<6;Ce++)!ge&&!z?le[Ce]=x(E.image[Ce],!0,s.maxCubemapSize):le[Ce]=z?E.image[Ce].image:E.image[Ce],le[Ce]=Ve(E,le[Ce]);let oe=le[0],Te=r.convert(E.format,E.colorSpace),ve=r.convert(E.type),Me=S(E.internalFormat,Te,ve,E.normalized,E.colorSpace),We=E.isVideoTexture!==!0,Ke=ye.__version===void 0||de===!0,fe=ce.dataReady,Be=w(E,oe);ft(n.TEXTURE_CUBE_MAP,E);let je;if(E.isDepthTexture){if(Me=m(E.format===Os,E.type),Ke)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,oe.width,oe.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,oe.width,oe.height,0,Te,ve,null)}else if(ge){We&&Ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,oe.width,oe.height);for(let Ce=0;Ce<6;Ce++){je=le[Ce].mipmaps;for(let lt=0;lt<je.length;lt++){let Gt=je[lt];E.format!==Yi?Te!==null?We?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Gt.width,Gt.height,Te,Gt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Me,Gt.width,Gt.height,0,Gt.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Gt.width,Gt.height,Te,ve,Gt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Me,Gt.width,Gt.height,0,Te,ve,Gt.data)}}}else{if(je=E.mipmaps,We&&Ke){je.length>0&&Be++;let Ce=qe(le[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(z){We?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,le[Ce].width,le[Ce].height,Te,ve,le[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,le[Ce].width,le[Ce].height,0,Te,ve,le[Ce].data);for(let lt=0;lt<je.length;lt++){let Wn=je[lt].image[Ce].image;We?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Wn.width,Wn.height,Te,ve,Wn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Me,Wn.width,Wn.height,0,Te,ve,Wn.data)}}else{We?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,ve,le[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Te,ve,le[Ce]);for(let lt=0;lt<je.length;lt++){let Gt=je[lt];We?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Te,ve,Gt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Me,Te,ve,Gt.image[Ce])}}}M(E)&&E.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),ye.__version=ce.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function Dt(O,E,$,de,ce,ye){let be=r.convert($.format,$.colorSpace),re=r.convert($.type),ae=S($.internalFormat,be,re,$.normalized,$.colorSpace),ge=i.get(E),z=i.get($);if(z.__renderTarget=E,!ge.__hasExternalTextures){let le=Math.max(1,E.width>>ye),oe=Math.max(1,E.height>>ye);ce===n.TEXTURE_3D||ce===n.TEXTURE_2D_ARRAY?t.texImage3D(ce,ye,ae,le,oe,E.depth,0,be,re,null):t.texImage2D(ce,ye,ae,le,oe,0,be,re,null)}t.bindFramebuffer(n.FRAMEBUFFER,O),we(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ce,z.__webglTexture,0,ot(E)):(ce===n.TEXTURE_2D||ce>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,ce,z.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(O,E,$){if(n.bindRenderbuffer(n.RENDERBUFFER,O),E.depthBuffer){let de=E.depthTexture,ce=de&&de.isDepthTexture?de.type:null,ye=m(E.stencilBuffer,ce),be=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(E),ye,E.width,E.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(E),ye,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,ye,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,O)}else{let de=E.textures;for(let ce=0;ce<de.length;ce++){let ye=de[ce],be=r.convert(ye.format,ye.colorSpace),re=r.convert(ye.type),ae=S(ye.internalFormat,be,re,ye.normalized,ye.colorSpace);we(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(E),ae,E.width,E.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(E),ae,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,ae,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(O,E,$){let de=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,O),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=i.get(E.depthTexture);ce.__renderTarget=E;let ye=de?E.depthTexture.image[0]:E.depthTexture.image;(!ce.__webglTexture||ye.width!==E.width||ye.height!==E.height)&&(ye.width=E.width,ye.height=E.height,E.depthTexture.needsUpdate=!0),de?xe(E.depthTexture,0):he(E.depthTexture,0);let be=ce.__webglTexture,re=ot(E),ae=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,ge=E.depthTexture.format===Os?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===Es)we(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ae,be,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ae,be,0);else if(E.depthTexture.format===Os)we(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ae,be,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ae,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(O){let E=i.get(O),$=O.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==O.depthTexture){let de=O.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),de){let ce=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,de.removeEventListener("dispose",ce)};de.addEventListener("dispose",ce),E.__depthDisposeCallback=ce}E.__boundDepthTexture=de}if(O.depthTexture&&!E.__autoAllocateDepthBuffer)if($)for(let de=0;de<6;de++)bt(E.__webglFramebuffer[de],O,de);else O.texture.mipmaps.length>0?bt(E.__webglFramebuffer[0],O,0):bt(E.__webglFramebuffer,O,0);else if($){E.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[de]),E.__webglDepthbuffer[de]===void 0)E.__webglDepthbuffer[de]=n.createRenderbuffer(),wn(E.__webglDepthbuffer[de],O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=E.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,ye)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),wn(E.__webglDepthbuffer,O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function jt(O,E,$){let de=i.get(O);E!==void 0&&Dt(de.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&mn(O)}function an(O){let E=O.texture,$=i.get(O),de=i.get(E);O.addEventListener("dispose",N),I(O);let ce=O.textures,ye=O.isWebGLCubeRenderTarget===!0,be=ce.length>1;if(be||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=E.version,o.memory.textures++),ye){$.__webglFramebuffer=[];for(let re=0;re<6;re++)if(E.mipmaps.length>0){$.__webglFramebuffer[re]=[];for(let ae=0;ae<E.mipmaps.length;ae++)$.__webglFramebuffer[re][ae]=n.createFramebuffer()}else $.__webglFramebuffer[re]=n.createFramebuffer()}else{if(E.mipmaps.length>0){$.__webglFramebuffer=[];for(let re=0;re<E.mipmaps.length;re++)$.__webglFramebuffer[re]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(be)for(let re=0,ae=ce.length;re<ae;re++){let ge=i.get(ce[re]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&we(O)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let re=0;re<ce.length;re++){let ae=ce[re];$.__webglColorRenderbuffer[re]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[re]);let ge=r.convert(ae.format,ae.colorSpace),z=r.convert(ae.type),le=S(ae.internalFormat,ge,z,ae.normalized,ae.colorSpace,O.isXRRenderTarget===!0),oe=ot(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,oe,le,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+re,n.RENDERBUFFER,$.__webglColorRenderbuffer[re])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),wn($.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),ft(n.TEXTURE_CUBE_MAP,E);for(let re=0;re<6;re++)if(E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Dt($.__webglFramebuffer[re][ae],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,ae);else Dt($.__webglFramebuffer[re],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0);M(E)?b(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(be){for(let re=0,ae=ce.length;re<ae;re++){let ge=ce[re],z=i.get(ge),le=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(le=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(le,z.__webglTexture),ft(le,ge),Dt($.__webglFramebuffer,O,ge,n.COLOR_ATTACHMENT0+re,le,0),M(ge)&&b(le)}t.unbindTexture()}else{let re=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(re=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,de.__webglTexture),ft(re,E),E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Dt($.__webglFramebuffer[ae],O,E,n.COLOR_ATTACHMENT0,re,ae);else Dt($.__webglFramebuffer,O,E,n.COLOR_ATTACHMENT0,re,0);M(E)?b(re):E.mipmaps.length>0&&n.texParameteri(re,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&mn(O)}function V(O){let E=O.textures;for(let $=0,de=E.length;$<de;$++){let ce=E[$];if(M(ce)&&ce.mipmapsAutoUpdate===!0){let ye=y(O),be=i.get(ce).__webglTexture;t.bindTexture(ye,be),b(ye),t.unbindTexture()}}}let Re=[];function Je(O){if(O.samples>0){if(we(O)===!1){let E=O.textures,$=O.width,de=O.height,ce=n.COLOR_BUFFER_BIT,ye=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(O),re=E.length>1;if(re)for(let ge=0;ge<E.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ge=0;ge<E.length;ge++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ce|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ce|=n.STENCIL_BUFFER_BIT)),re){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let z=i.get(E[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,$,de,0,0,$,de,ce,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+ge),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Re.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),re)for(let ge=0;ge<E.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let z=i.get(E[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,z,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let E=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function ot(O){return Math.min(s.maxSamples,O.samples)}function we(O){let E=i.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Ot(O){let E=o.render.frame;u.get(O)!==E&&(u.set(O,E),O.update())}function Ve(O,E){let $=O.colorSpace,de=O.format,ce=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||$!==Fa&&$!==Fs&&(vt.getTransfer($)===Ct?(de!==Yi||ce!==si)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",$)),E}function qe(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=ne,this.resetTextureUnits=K,this.getTextureUnits=q,this.setTextureUnits=ie,this.setTexture2D=he,this.setTexture2DArray=pe,this.setTexture3D=_e,this.setTextureCube=xe,this.rebindTextures=jt,this.setupRenderTarget=an,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=we,this.dispose=G}function DT(n,e){function t(i,s=Fs){let r,o=vt.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===fu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===du)return n.UNSIGNED_SHORT_5_5_5_1;if(i===dd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===pd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===hd)return n.BYTE;if(i===fd)return n.SHORT;if(i===$o)return n.UNSIGNED_SHORT;if(i===hu)return n.INT;if(i===Xi)return n.UNSIGNED_INT;if(i===Ii)return n.FLOAT;if(i===qi)return n.HALF_FLOAT;if(i===md)return n.ALPHA;if(i===gd)return n.RGB;if(i===Yi)return n.RGBA;if(i===Es)return n.DEPTH_COMPONENT;if(i===Os)return n.DEPTH_STENCIL;if(i===pu)return n.RED;if(i===mu)return n.RED_INTEGER;if(i===ur)return n.RG;if(i===gu)return n.RG_INTEGER;if(i===_u)return n.RGBA_INTEGER;if(i===ll||i===cl||i===ul||i===hl)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ll)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ll)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===cl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===hl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===xu||i===vu||i===yu||i===bu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===xu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===vu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===yu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===bu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Su||i===Mu||i===wu||i===Tu||i===Au||i===fl||i===Eu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Su||i===Mu)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===wu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Tu)return r.COMPRESSED_R11_EAC;if(i===Au)return r.COMPRESSED_SIGNED_R11_EAC;if(i===fl)return r.COMPRESSED_RG11_EAC;if(i===Eu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Cu||i===Ru||i===Pu||i===Iu||i===Lu||i===Du||i===Nu||i===Ou||i===Fu||i===Uu||i===Bu||i===ku||i===zu||i===Vu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Cu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ru)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Pu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Iu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Lu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Du)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Nu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ou)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Fu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Uu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Bu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ku)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===zu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Vu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Gu||i===Hu||i===Wu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Gu)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Hu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Wu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Xu||i===qu||i===dl||i===Yu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Xu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===qu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===dl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Yu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Gr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var NT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,OT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ud=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Pi({vertexShader:NT,fragmentShader:OT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new On(new Za(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Bd=class extends Wi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,_=null,v=typeof XRWebGLBinding<"u",p=new Ud,g={},x=t.getContextAttributes(),M=null,b=null,y=[],S=[],m=new tt,w=null,I=null,P=new mi;P.viewport=new zt;let L=new mi;L.viewport=new zt;let N=[P,L],B=new ou,D=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let he=y[j];return he===void 0&&(he=new zo,y[j]=he),he.getTargetRaySpace()},this.getControllerGrip=function(j){let he=y[j];return he===void 0&&(he=new zo,y[j]=he),he.getGripSpace()},this.getHand=function(j){let he=y[j];return he===void 0&&(he=new zo,y[j]=he),he.getHandSpace()};function J(j){let he=S.indexOf(j.inputSource);if(he===-1)return;let pe=y[he];pe!==void 0&&(pe.update(j.inputSource,j.frame,c||o),pe.dispatchEvent({type:j.type,data:j.inputSource}))}function k(){s.removeEventListener("select",J),s.removeEventListener("selectstart",J),s.removeEventListener("selectend",J),s.removeEventListener("squeeze",J),s.removeEventListener("squeezestart",J),s.removeEventListener("squeezeend",J),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",se);for(let j=0;j<y.length;j++){let he=S[j];he!==null&&(S[j]=null,y[j].disconnect(he))}D=null,G=null,p.reset();for(let j in g)delete g[j];if(e.setRenderTarget(M),d=null,f=null,h=null,s=null,b=null,ne.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(m.width,m.height,!1),I!==null){let j=I.camera;j.fov=I.fov,j.zoom=I.zoom,j.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",J),s.addEventListener("selectstart",J),s.addEventListener("selectend",J),s.addEventListener("squeeze",J),s.addEventListener("squeezestart",J),s.addEventListener("squeezeend",J),s.addEventListener("end",k),s.addEventListener("inputsourceschange",se),x.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(m),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let pe=null,_e=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,pe=x.stencil?Os:Es,_e=x.stencil?Gr:Xi);let Ge={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ge),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new gi(f.textureWidth,f.textureHeight,{format:Yi,type:si,depthTexture:new Ls(f.textureWidth,f.textureHeight,_e,void 0,void 0,void 0,void 0,void 0,void 0,pe),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let pe={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,pe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new gi(d.framebufferWidth,d.framebufferHeight,{format:Yi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ne.setContext(s),ne.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function se(j){for(let he=0;he<j.removed.length;he++){let pe=j.removed[he],_e=S.indexOf(pe);_e>=0&&(S[_e]=null,y[_e].disconnect(pe))}for(let he=0;he<j.added.length;he++){let pe=j.added[he],_e=S.indexOf(pe);if(_e===-1){for(let Ge=0;Ge<y.length;Ge++)if(Ge>=S.length){S.push(pe),_e=Ge;break}else if(S[Ge]===null){S[Ge]=pe,_e=Ge;break}if(_e===-1)break}let xe=y[_e];xe&&xe.connect(pe)}}function Y(j,he){he===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(he.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let he=j.near,pe=j.far;p.texture!==null&&(p.depthNear>0&&(he=p.depthNear),p.depthFar>0&&(pe=p.depthFar)),B.near=L.near=P.near=he,B.far=L.far=P.far=pe,(D!==B.near||G!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),D=B.near,G=B.far),B.layers.mask=j.layers.mask|6,P.layers.mask=B.layers.mask&-5,L.layers.mask=B.layers.mask&-3;let _e=j.parent,xe=B.cameras;Y(B,_e);for(let Ge=0;Ge<xe.length;Ge++)Y(xe[Ge],_e);B.projectionMatrix.copy(P.projectionMatrix),B.projectionMatrixInverse.copy(P.projectionMatrixInverse),I===null&&j.isPerspectiveCamera&&(I={camera:j,fov:j.fov,zoom:j.zoom}),K(j,B,_e)};function K(j,he,pe){pe===null?j.matrix.copy(he.matrixWorld):(j.matrix.copy(pe.matrixWorld),j.matrix.invert(),j.matrix.multiply(he.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(he.projectionMatrix),j.projectionMatrixInverse.copy(he.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=Uo*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(B)},this.getCameraTexture=function(j){return g[j]};let q=null;function ie(j,he){if(u=he.getViewerPose(c||o),_=he,u!==null){let pe=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let _e=!1;pe.length!==B.cameras.length&&(B.cameras.length=0,_e=!0);for(let He=0;He<pe.length;He++){let ft=pe[He],ct=null;if(d!==null)ct=d.getViewport(ft);else{let $t=h.getViewSubImage(f,ft);ct=$t.viewport,He===0&&(e.setRenderTargetTextures(b,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(b))}let it=N[He];it===void 0&&(it=new mi,it.layers.enable(He),it.viewport=new zt,N[He]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),He===0&&(B.matrix.copy(it.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),_e===!0&&B.cameras.push(it)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let He=h.getDepthInformation(pe[0]);He&&He.isValid&&He.texture&&p.init(He,s.renderState)}if(xe&&xe.includes("camera-access")&&v){e.state.unbindTexture(),h=i.getBinding();for(let He=0;He<pe.length;He++){let ft=pe[He].camera;if(ft){let ct=g[ft];ct||(ct=new Ja,g[ft]=ct);let it=h.getCameraImage(ft);ct.sourceTexture=it}}}}for(let pe=0;pe<y.length;pe++){let _e=S[pe],xe=y[pe];_e!==null&&xe!==void 0&&xe.update(_e,he,c||o)}q&&q(j,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),_=null}let ne=new B_;ne.setAnimationLoop(ie),this.setAnimationLoop=function(j){q=j},this.dispose=function(){}}},FT=new gt,$_=new nt;$_.set(-1,0,0,0,1,0,0,0,1);function UT(n,e){function t(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,Td(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,x,M,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),u(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),f(p,g),g.isMeshPhysicalMaterial&&d(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),_(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),v(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,x,M):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,t(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===Qn&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,t(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===Qn&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,t(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,t(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let x=e.get(g),M=x.envMap,b=x.envMapRotation;M&&(p.envMap.value=M,p.envMapRotation.value.setFromMatrix4(FT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply($_),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,x,M){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*x,p.scale.value=M*.5,g.map&&(p.map.value=g.map,t(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function u(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function f(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function d(p,g,x){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Qn&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,g){g.matcap&&(p.matcap.value=g.matcap)}function v(p,g){let x=e.get(g).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function BT(n,e,t,i){let s={},r={};function o(x,M){let b=M.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,M){let b=s[x.id];b===void 0&&(_(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",p));let y=M.program;i.updateUBOMapping(x,y);let S=e.render.frame;r[x.id]!==S&&(c(x),r[x.id]=S)}function l(x){let M=n.createBuffer(),b=x.__size,y=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,b,y),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],b=x.uniforms,y=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let S=0,m=b.length;S<m;S++){let w=b[S];if(Array.isArray(w))for(let I=0,P=w.length;I<P;I++)u(w[I],S,I,y);else u(w,S,0,y)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,b,y){if(f(x,M,b,y)===!0){let S=x.__offset,m=x.value;if(Array.isArray(m)){let w=0;for(let I=0;I<m.length;I++){let P=m[I],L=v(P,!0);h(P,x.__data,w),w+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(m,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,x.__data)}}function h(x,M,b){typeof x=="number"||typeof x=="boolean"?M[b]=x:x.isMatrix3?(M[b]=x.elements[0],M[b+1]=x.elements[1],M[b+2]=x.elements[2],M[b+3]=0,M[b+4]=x.elements[3],M[b+5]=x.elements[4],M[b+6]=x.elements[5],M[b+7]=0,M[b+8]=x.elements[6],M[b+9]=x.elements[7],M[b+10]=x.elements[8],M[b+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-b),b):x.toArray(M,b)}function f(x,M,b,y){let S=x.value,m=M+"_"+b;if(Array.isArray(S)){y[m]===void 0&&(y[m]=[]);let w=y[m],I=!1;for(let P=0;P<S.length;P++)d(S[P],w,P)===!0&&(I=!0);return I}return d(S,y,m)}function d(x,M,b){if(M[b]===void 0)return typeof x=="number"||typeof x=="boolean"?M[b]=x:ArrayBuffer.isView(x)?M[b]=x.slice():M[b]=x.clone(),!0;{let y=M[b];if(typeof x=="number"||typeof x=="boolean"){if(y!==x)return M[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(y.equals(x)===!1)return y.copy(x),!0}}return!1}function _(x){let M=x.uniforms,b=0,y=16;for(let m=0,w=M.length;m<w;m++){let I=Array.isArray(M[m])?M[m]:[M[m]];for(let P=0,L=I.length;P<L;P++){let N=I[P],B=Array.isArray(N.value)?N.value:[N.value],D=Array.isArray(M[m])||Array.isArray(N.value),G=b;for(let k=0,se=B.length;k<se;k++){let Y=B[k],K=v(Y,D),q=b%y,ie=q%K.boundary,ne=q+ie;b+=ie,ne!==0&&y-ne<K.storage&&(b+=y-ne),k===0&&(G=b),b+=K.storage}let J=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new J((b-G)/Float32Array.BYTES_PER_ELEMENT),N.__offset=G}}let S=b%y;return S>0&&(b+=y-S),x.__size=b,x.__cache={},this}function v(x,M){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(x){let M=x.target;M.removeEventListener("dispose",p),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var kT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function zT(){return us===null&&(us=new Ur(kT,16,16,ur,qi),us.name="DFG_LUT",us.minFilter=jn,us.magFilter=jn,us.wrapS=os,us.wrapT=os,us.generateMipmaps=!1,us.needsUpdate=!0),us}var Ko=class{constructor(e={}){let{canvas:t=a_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=si}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let v=d,p=new Set([_u,gu,mu]),g=new Set([si,Xi,$o,Gr,fu,du]),x=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},y=null,S=null,m=[],w=[],I=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,L=!1,N=null,B=null,D=null,G=null;this._outputColorSpace=Gn;let J=0,k=0,se=null,Y=-1,K=null,q=new zt,ie=new zt,ne=null,j=new at(0),he=0,pe=t.width,_e=t.height,xe=1,Ge=null,rt=null,He=new zt(0,0,pe,_e),ft=new zt(0,0,pe,_e),ct=!1,it=new ir,$t=new Hc,Vt=!1,on=!1,Dt=new gt,wn=new X,bt=new zt,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},jt=!1;function an(){return se===null?xe:1}let V=i;function Re(R,H){return t.getContext(R,H)}let Je,ot,we,Ot,Ve,qe,O,E,$,de,ce,ye,be,re,ae,ge,z,le,oe,Te,ve,Me,We;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),V===null){let H="webgl2";if(V=Re(H,R),V===null)throw Re(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(R){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Qe("WebGLRenderer: "+R.message),R}function Ke(){Je=new Kw(V),Je.init(),ve=new DT(V,Je),ot=new zw(V,Je,e,ve),we=new IT(V,Je),ot.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),B=V.createFramebuffer(),D=V.createFramebuffer(),G=V.createFramebuffer(),Ot=new e1(V),Ve=new _T,qe=new LT(V,Je,we,Ve,ot,ve,Ot),O=new Zw(P),E=new nS(V),Me=new Bw(V,E),$=new jw(V,E,Ot,Me),de=new n1(V,$,E,Me,Ot),le=new t1(V,ot,qe),ae=new Vw(Ve),ce=new gT(P,O,Je,ot,Me,ae),ye=new UT(P,Ve),be=new vT,re=new TT(Je),z=new Uw(P,O,we,de,_,l),ge=new PT(P,de,ot),We=new BT(V,Ot,ot,we),oe=new kw(V,Je,Ot),Te=new Qw(V,Je,Ot),Ot.programs=ce.programs,P.capabilities=ot,P.extensions=Je,P.properties=Ve,P.renderLists=be,P.shadowMap=ge,P.state=we,P.info=Ot}v!==si&&(I=new s1(v,t.width,t.height,a,s,r));let fe=new Bd(P,V);this.xr=fe,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let R=Je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(R){R!==void 0&&(xe=R,this.setSize(pe,_e,!1))},this.getSize=function(R){return R.set(pe,_e)},this.setSize=function(R,H,te=!0){if(fe.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}pe=R,_e=H,t.width=Math.floor(R*xe),t.height=Math.floor(H*xe),te===!0&&(t.style.width=R+"px",t.style.height=H+"px"),I!==null&&I.setSize(t.width,t.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(pe*xe,_e*xe).floor()},this.setDrawingBufferSize=function(R,H,te){pe=R,_e=H,xe=te,t.width=Math.floor(R*te),t.height=Math.floor(H*te),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(v===si){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(q)},this.getViewport=function(R){return R.copy(He)},this.setViewport=function(R,H,te,Z){R.isVector4?He.set(R.x,R.y,R.z,R.w):He.set(R,H,te,Z),we.viewport(q.copy(He).multiplyScalar(an()).round())},this.getScissor=function(R){return R.copy(ft)},this.setScissor=function(R,H,te,Z){R.isVector4?ft.set(R.x,R.y,R.z,R.w):ft.set(R,H,te,Z),we.scissor(ie.copy(ft).multiplyScalar(an()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(R){we.setScissorTest(ct=R)},this.setOpaqueSort=function(R){Ge=R},this.setTransparentSort=function(R){rt=R},this.getClearColor=function(R){return R.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,te=!0){let Z=0;if(R){let Q=!1;if(se!==null){let Ae=se.texture.format;Q=p.has(Ae)}if(Q){let Ae=se.texture.type,Pe=g.has(Ae),Ee=z.getClearColor(),Ie=z.getClearAlpha(),ze=Ee.r,et=Ee.g,dt=Ee.b;Pe?(x[0]=ze,x[1]=et,x[2]=dt,x[3]=Ie,V.clearBufferuiv(V.COLOR,0,x)):(M[0]=ze,M[1]=et,M[2]=dt,M[3]=Ie,V.clearBufferiv(V.COLOR,0,M))}else Z|=V.COLOR_BUFFER_BIT}H&&(Z|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(Z|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&V.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),N=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),z.dispose(),be.dispose(),re.dispose(),qe.dispose(),Ve.dispose(),O.dispose(),de.dispose(),$.dispose(),Me.dispose(),We.dispose(),ce.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",yl),fe.removeEventListener("sessionend",Zi),fs.stop()};function Be(R){R.preventDefault(),bd("WebGLRenderer: Context Lost."),L=!0}function je(){bd("WebGLRenderer: Context Restored."),L=!1;let R=Ot.autoReset,H=ge.enabled,te=ge.autoUpdate,Z=ge.needsUpdate,Q=ge.type;Ke(),Ot.autoReset=R,ge.enabled=H,ge.autoUpdate=te,ge.needsUpdate=Z,ge.type=Q}function Ce(R){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function lt(R){let H=R.target;H.removeEventListener("dispose",lt),Gt(H)}function Gt(R){Wn(R),Ve.remove(R)}function Wn(R){let H=Ve.get(R).programs;H!==void 0&&(H.forEach(function(te){ce.releaseProgram(te)}),R.isShaderMaterial&&ce.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,te,Z,Q,Ae){H===null&&(H=mn);let Pe=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Ee=ia(R,H,te,Z,Q);we.setMaterial(Z,Pe);let Ie=te.index,ze=1;if(Z.wireframe===!0){if(Ie=$.getWireframeAttribute(te),Ie===void 0)return;ze=2}let et=te.drawRange,dt=te.attributes.position,ke=et.start*ze,pt=(et.start+et.count)*ze;Ae!==null&&(ke=Math.max(ke,Ae.start*ze),pt=Math.min(pt,(Ae.start+Ae.count)*ze)),Ie!==null?(ke=Math.max(ke,0),pt=Math.min(pt,Ie.count)):dt!=null&&(ke=Math.max(ke,0),pt=Math.min(pt,dt.count));let Kt=pt-ke;if(Kt<0||Kt===1/0)return;Me.setup(Q,Z,Ee,te,Ie);let Rt,Pt=oe;if(Ie!==null&&(Rt=E.get(Ie),Pt=Te,Pt.setIndex(Rt)),Q.isMesh)Z.wireframe===!0?(we.setLineWidth(Z.wireframeLinewidth*an()),Pt.setMode(V.LINES)):Pt.setMode(V.TRIANGLES);else if(Q.isLine){let gn=Z.linewidth;gn===void 0&&(gn=1),we.setLineWidth(gn*an()),Q.isLineSegments?Pt.setMode(V.LINES):Q.isLineLoop?Pt.setMode(V.LINE_LOOP):Pt.setMode(V.LINE_STRIP)}else Q.isPoints?Pt.setMode(V.POINTS):Q.isSprite&&Pt.setMode(V.TRIANGLES);if(Q.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Pt.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let gn=Q._multiDrawStarts,Fe=Q._multiDrawCounts,ln=Q._multiDrawCount,_t=Ie?E.get(Ie).bytesPerElement:1,ps=Ve.get(Z).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)ps.setValue(V,"_gl_DrawID",cn),Pt.render(gn[cn]/_t,Fe[cn])}else if(Q.isInstancedMesh)Pt.renderInstances(ke,Kt,Q.count);else if(te.isInstancedBufferGeometry){let gn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,Fe=Math.min(te.instanceCount,gn);Pt.renderInstances(ke,Kt,Fe)}else Pt.render(ke,Kt)};function ea(R,H,te,Z){N!==null&&R.isNodeMaterial&&N.setObject(Z,R),Vt===!0&&ae.setState(R,te,!1),R.transparent===!0&&R.side===ii&&R.forceSinglePass===!1?(R.side=Qn,R.needsUpdate=!0,Ki(R,H,Z),R.side=cr,R.needsUpdate=!0,Ki(R,H,Z),R.side=ii):Ki(R,H,Z)}this.compile=function(R,H,te=null){te===null&&(te=R),N!==null&&N.renderStart(R,H,te),S=re.get(te),S.init(H),w.push(S),te.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(S.pushLight(Q),Q.castShadow&&S.pushShadow(Q))}),R!==te&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(S.pushLight(Q),Q.castShadow&&S.pushShadow(Q))}),S.setupLights(),N!==null&&N.updateLights(S.state.lightsArray),on=this.localClippingEnabled,Vt=ae.init(this.clippingPlanes,on),Vt===!0&&ae.setGlobalState(this.clippingPlanes,H),N!==null&&ge.render(S.state.shadowsArray,te,H);let Z=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Ae=Q.material;if(Ae)if(Array.isArray(Ae))for(let Pe=0;Pe<Ae.length;Pe++){let Ee=Ae[Pe];ea(Ee,te,H,Q),Z.add(Ee)}else ea(Ae,te,H,Q),Z.add(Ae)}),S=w.pop(),N!==null&&N.renderEnd(),Z},this.compileAsync=function(R,H,te=null){let Z=this.compile(R,H,te);return new Promise(Q=>{function Ae(){if(Z.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Z.delete(Pe)}),Z.size===0){Q(R);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Wr=null;function hh(R){Wr&&Wr(R)}function yl(){fs.stop()}function Zi(){fs.start()}let fs=new B_;fs.setAnimationLoop(hh),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(R){Wr=R,fe.setAnimationLoop(R),R===null?fs.stop():fs.start()},fe.addEventListener("sessionstart",yl),fe.addEventListener("sessionend",Zi),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;N!==null&&N.renderStart(R,H);let te=fe.enabled===!0&&fe.isPresenting===!0,Z=I!==null&&(se===null||te)&&I.begin(P,se);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(H),H=fe.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,H,se),S=re.get(R,w.length),S.init(H),S.state.textureUnits=qe.getTextureUnits(),w.push(S),Dt.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?$t.setFromArrayCamera(H):it.setFromProjectionMatrix(Dt,Ri,H.reversedDepth),on=this.localClippingEnabled,Vt=ae.init(this.clippingPlanes,on),y=be.get(R,m.length),y.init(),m.push(y),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Pe=P.xr.getDepthSensingMesh();Pe!==null&&ds(Pe,H,-1/0,P.sortObjects)}ds(R,H,0,P.sortObjects),y.finish(),N!==null&&N.updateLights(S.state.lightsArray),P.sortObjects===!0&&y.sort(Ge,rt),jt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,jt&&z.addToRenderList(y,R),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&ae.beginShadows();let Q=S.state.shadowsArray;if(ge.render(Q,R,H),Vt===!0&&ae.endShadows(),(Z&&I.hasRenderPass())===!1){let Pe=y.opaque,Ee=y.transmissive;if(S.setupLights(),H.isArrayCamera){let Ie=H.cameras;if(Ee.length>0)for(let ze=0,et=Ie.length;ze<et;ze++){let dt=Ie[ze];Li(Pe,Ee,R,dt)}jt&&z.render(R);for(let ze=0,et=Ie.length;ze<et;ze++){let dt=Ie[ze];ta(y,R,dt,dt.viewport)}}else Ee.length>0&&Li(Pe,Ee,R,H),jt&&z.render(R),ta(y,R,H)}se!==null&&k===0&&(qe.updateMultisampleRenderTarget(se),qe.updateRenderTargetMipmap(se)),Z&&I.end(P),R.isScene===!0&&R.onAfterRender(P,R,H),Me.resetDefaultState(),Y=-1,K=null,w.pop(),w.length>0?(S=w[w.length-1],qe.setTextureUnits(S.state.textureUnits),Vt===!0&&ae.setGlobalState(P.clippingPlanes,S.state.camera)):S=null,m.pop(),m.length>0?y=m[m.length-1]:y=null,N!==null&&N.renderEnd()};function ds(R,H,te,Z){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Pe=H.isArrayCamera?$t:it;if(!R.frustumCulled||R.intersectsFrustum(Pe)){Z&&bt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Dt);let Ee=de.update(R),Ie=R.material;Ie.visible&&y.push(R,Ee,Ie,te,bt.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Pe=H.isArrayCamera?$t:it;if(!R.frustumCulled||R.intersectsFrustum(Pe)){let Ee=de.update(R),Ie=R.material;if(Z&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),bt.copy(R.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(R.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ie)){let ze=Ee.groups;for(let et=0,dt=ze.length;et<dt;et++){let ke=ze[et],pt=Ie[ke.materialIndex];pt&&pt.visible&&y.push(R,Ee,pt,te,bt.z,ke,H)}}else Ie.visible&&y.push(R,Ee,Ie,te,bt.z,null,H)}}}let Ae=R.children;for(let Pe=0,Ee=Ae.length;Pe<Ee;Pe++)ds(Ae[Pe],H,te,Z)}function ta(R,H,te,Z){let{opaque:Q,transmissive:Ae,transparent:Pe}=R;S.setupLightsView(te),Vt===!0&&ae.setGlobalState(P.clippingPlanes,te),Z&&we.viewport(q.copy(Z)),Q.length>0&&Qt(Q,H,te),Ae.length>0&&Qt(Ae,H,te),Pe.length>0&&Qt(Pe,H,te),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Li(R,H,te,Z){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Z.id]===void 0){let ke=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Z.id]=new gi(1,1,{generateMipmaps:!0,type:ke?qi:si,minFilter:Ns,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ae=S.state.transmissionRenderTarget[Z.id],Pe=Z.viewport||q;Ae.setSize(Pe.z*P.transmissionResolutionScale,Pe.w*P.transmissionResolutionScale);let Ee=P.getRenderTarget(),Ie=P.getActiveCubeFace(),ze=P.getActiveMipmapLevel();P.setRenderTarget(Ae),P.getClearColor(j),he=P.getClearAlpha(),he<1&&P.setClearColor(16777215,.5),P.clear(),jt&&z.render(te);let et=P.toneMapping;P.toneMapping=cs;let dt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),S.setupLightsView(Z),Vt===!0&&ae.setGlobalState(P.clippingPlanes,Z),Qt(R,te,Z),qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let pt=0,Kt=H.length;pt<Kt;pt++){let Rt=H[pt],{object:Pt,geometry:gn,material:Fe,group:ln}=Rt;if(Fe.side===ii&&Pt.layers.test(Z.layers)){let _t=Fe.side;Fe.side=Qn,Fe.needsUpdate=!0,sn(Pt,te,Z,gn,Fe,ln),Fe.side=_t,Fe.needsUpdate=!0,ke=!0}}ke===!0&&(qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae))}P.setRenderTarget(Ee,Ie,ze),P.setClearColor(j,he),dt!==void 0&&(Z.viewport=dt),P.toneMapping=et}function Qt(R,H,te){let Z=H.isScene===!0?H.overrideMaterial:null;for(let Q=0,Ae=R.length;Q<Ae;Q++){let Pe=R[Q],{object:Ee,geometry:Ie,group:ze}=Pe,et=Pe.material;et.allowOverride===!0&&Z!==null&&(et=Z),Ee.layers.test(te.layers)&&sn(Ee,H,te,Ie,et,ze)}}function sn(R,H,te,Z,Q,Ae){N!==null&&Q.isNodeMaterial&&N.setObject(R,Q),R.onBeforeRender(P,H,te,Z,Q,Ae),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(P,H,te,Z,R,Ae),Q.transparent===!0&&Q.side===ii&&Q.forceSinglePass===!1?(Q.side=Qn,Q.needsUpdate=!0,P.renderBufferDirect(te,H,Z,Q,R,Ae),Q.side=cr,Q.needsUpdate=!0,P.renderBufferDirect(te,H,Z,Q,R,Ae),Q.side=ii):P.renderBufferDirect(te,H,Z,Q,R,Ae),R.onAfterRender(P,H,te,Z,Q,Ae)}function rn(R){let H=0;for(let te of R)te.texture!==null&&H++;return H}function Ki(R,H,te){H.isScene!==!0&&(H=mn);let Z=Ve.get(R),Q=S.state.lights,Ae=S.state.shadowsArray,Pe=Q.state.version,Ee=ce.getParameters(R,Q.state,Ae,H,te,S.state.lightProbeGridArray),Ie=ce.getProgramCacheKey(Ee),ze=Z.programs;Z.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Z.fog=H.fog;let et=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Z.envMap=O.get(R.envMap||Z.environment,et),Z.envMapRotation=Z.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,ze===void 0&&(R.addEventListener("dispose",lt),ze=new Map,Z.programs=ze,Z.programVariants=new Map);let dt=ze.get(Ie);if(dt!==void 0){if(Z.currentProgram===dt&&Z.lightsStateVersion===Pe)return na(R,Ee),dt}else Ee.uniforms=ce.getUniforms(R),N!==null&&R.isNodeMaterial&&N.build(R,te,Ee),R.onBeforeCompile(Ee,P),dt=ce.acquireProgram(Ee,Ie),ze.set(Ie,dt),Z.uniforms=Ee.uniforms;let ke=Z.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(ke.clippingPlanes=ae.uniform),na(R,Ee),Z.needsLights=ks(R),Z.lightsStateVersion=Pe,Z.needsLights&&(ke.ambientLightColor.value=Q.state.ambient,ke.lightProbe.value=Q.state.probe,ke.sunLights.value=Q.state.sun,ke.sunLightShadows.value=Q.state.sunShadow,ke.directionalLights.value=Q.state.directional,ke.directionalLightShadows.value=Q.state.directionalShadow,ke.spotLights.value=Q.state.spot,ke.spotLightShadows.value=Q.state.spotShadow,ke.rectAreaLights.value=Q.state.rectArea,ke.ltc_1.value=Q.state.rectAreaLTC1,ke.ltc_2.value=Q.state.rectAreaLTC2,ke.pointLights.value=Q.state.point,ke.pointLightShadows.value=Q.state.pointShadow,ke.hemisphereLights.value=Q.state.hemi,ke.sunShadowMatrix.value=Q.state.sunShadowMatrix,ke.sunShadowCascade.value=Q.state.sunShadowCascade,ke.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,ke.spotLightMatrix.value=Q.state.spotLightMatrix,ke.spotLightMap.value=Q.state.spotLightMap,ke.pointShadowMatrix.value=Q.state.pointShadowMatrix),Z.numLightProbeGrids=rn(S.state.lightProbeGridArray),Z.currentProgram=dt,Z.uniformsList=null,dt}function ri(R,H,te,Z,Q){let Ae=Ve.get(R),Pe=Ae.currentProgram.id+","+Z+","+Q,Ee=Ae.programVariants.get(Pe);return Ee===void 0?(Ee=Ki(R,H,te),Ae.programVariants.set(Pe,Ee)):(Ae.currentProgram=Ee,Ae.uniformsList=null,Ae.outputColorSpace=Z,Ae.toneMapping=Q),Ee}function Bs(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=Zo.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function na(R,H){let te=Ve.get(R);te.outputColorSpace=H.outputColorSpace,te.batching=H.batching,te.batchingColor=H.batchingColor,te.instancing=H.instancing,te.instancingColor=H.instancingColor,te.instancingMorph=H.instancingMorph,te.skinning=H.skinning,te.morphTargets=H.morphTargets,te.morphNormals=H.morphNormals,te.morphColors=H.morphColors,te.morphTargetsCount=H.morphTargetsCount,te.numClippingPlanes=H.numClippingPlanes,te.numIntersection=H.numClipIntersection,te.vertexAlphas=H.vertexAlphas,te.vertexTangents=H.vertexTangents,te.toneMapping=H.toneMapping}function ia(R,H,te,Z,Q){H.isScene!==!0&&(H=mn),qe.resetTextureUnits();let Ae=H.fog,Pe=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?H.environment:null,Ee=se===null?P.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:vt.workingColorSpace,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,ze=O.get(Z.envMap||Pe,Ie),et=Z.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,dt=!!te.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),ke=!!te.morphAttributes.position,pt=!!te.morphAttributes.normal,Kt=!!te.morphAttributes.color,Rt=cs;Z.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(Rt=P.toneMapping);let Pt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,gn=Pt!==void 0?Pt.length:0,Fe=Ve.get(Z),ln=S.state.lights;if(Vt===!0&&(on===!0||R!==K)){let It=R===K&&Z.id===Y;ae.setState(Z,R,It)}let _t=!1,ps=!1;Z.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==ln.state.version||Q.isBatchedMesh&&Fe.batching===!1||!Q.isBatchedMesh&&Fe.batching===!0||Q.isBatchedMesh&&Fe.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Fe.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Fe.instancing===!1||!Q.isInstancedMesh&&Fe.instancing===!0||Q.isSkinnedMesh&&Fe.skinning===!1||!Q.isSkinnedMesh&&Fe.skinning===!0||Q.isInstancedMesh&&Fe.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Fe.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Fe.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Fe.instancingMorph===!1&&Q.morphTexture!==null||Fe.envMap!==ze||Z.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ae.numPlanes||Fe.numIntersection!==ae.numIntersection)||Fe.vertexAlphas!==et||Fe.vertexTangents!==dt||Fe.morphTargets!==ke||Fe.morphNormals!==pt||Fe.morphColors!==Kt||Fe.morphTargetsCount!==gn||Fe.numLightProbeGrids!==rn(S.state.lightProbeGridArray)?_t=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==Rt)&&(ps=!0):(_t=!0,Fe.__version=Z.version);let cn=Fe.currentProgram;(_t===!0||ps===!0)&&(cn=ps===!0?ri(Z,H,Q,Ee,Rt):Ki(Z,H,Q),N&&Z.isNodeMaterial&&N.onUpdateProgram(Z,cn,Fe));let Yr=!1,ji=!1,ms=!1,ut=cn.getUniforms(),en=Fe.uniforms;if(we.useProgram(cn.program)&&(Yr=!0,ji=!0,ms=!0),Z.id!==Y&&(Y=Z.id,ji=!0),Yr||K!==R){we.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ut.setValue(V,"projectionMatrix",R.projectionMatrix),ut.setValue(V,"viewMatrix",R.matrixWorldInverse);let un=ut.map.cameraPosition;un!==void 0&&un.setValue(V,wn.setFromMatrixPosition(R.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(V,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ut.setValue(V,"isOrthographic",R.isOrthographicCamera===!0),K!==R&&(K=R,ji=!0,ms=!0)}if(Fe.needsLights&&(ln.state.sunShadowMap.length>0&&ut.setValue(V,"sunShadowMap",ln.state.sunShadowMap,qe),ln.state.directionalShadowMap.length>0&&ut.setValue(V,"directionalShadowMap",ln.state.directionalShadowMap,qe),ln.state.spotShadowMap.length>0&&ut.setValue(V,"spotShadowMap",ln.state.spotShadowMap,qe),ln.state.pointShadowMap.length>0&&ut.setValue(V,"pointShadowMap",ln.state.pointShadowMap,qe)),Q.isSkinnedMesh){ut.setOptional(V,Q,"bindMatrix"),ut.setOptional(V,Q,"bindMatrixInverse");let It=Q.skeleton;It&&(It.boneTexture===null&&It.computeBoneTexture(),ut.setValue(V,"boneTexture",It.boneTexture,qe))}Q.isBatchedMesh&&(ut.setOptional(V,Q,"batchingTexture"),ut.setValue(V,"batchingTexture",Q._matricesTexture,qe),ut.setOptional(V,Q,"batchingIdTexture"),ut.setValue(V,"batchingIdTexture",Q._indirectTexture,qe),ut.setOptional(V,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ut.setValue(V,"batchingColorTexture",Q._colorsTexture,qe));let Xn=te.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&le.update(Q,te,cn),(ji||Fe.receiveShadow!==Q.receiveShadow)&&(Fe.receiveShadow=Q.receiveShadow,ut.setValue(V,"receiveShadow",Q.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&H.environment!==null&&(en.envMapIntensity.value=H.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=zT()),ji){if(ut.setValue(V,"toneMappingExposure",P.toneMappingExposure),Fe.needsLights&&Xr(en,ms),Ae&&Z.fog===!0&&ye.refreshFogUniforms(en,Ae),ye.refreshMaterialUniforms(en,Z,xe,_e,S.state.transmissionRenderTarget[R.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let It=b,un=0;for(let kn of S.state.lightProbeGridArray)kn.texture!==null&&(It.textures[un]=kn.texture,It.min[un]=kn.boundingBox.min,It.max[un]=kn.boundingBox.max,It.resolution[un]=kn.resolution,un++);for(let kn in It)It[kn].length=un;en.probesSH.value=It.textures,en.probesMin.value=It.min,en.probesMax.value=It.max,en.probesResolution.value=It.resolution}Zo.upload(V,Bs(Fe),en,qe)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Zo.upload(V,Bs(Fe),en,qe),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ut.setValue(V,"center",Q.center),ut.setValue(V,"modelViewMatrix",Q.modelViewMatrix),ut.setValue(V,"normalMatrix",Q.normalMatrix),ut.setValue(V,"modelMatrix",Q.matrixWorld),Z.uniformsGroups!==void 0){let It=Z.uniformsGroups;for(let un=0,kn=It.length;un<kn;un++){let bl=It[un];We.update(bl,cn),We.bind(bl,cn)}}return cn}function Xr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return J},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(R,H,te){let Z=Ve.get(R);Z.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Ve.get(R.texture).__webglTexture=H,Ve.get(R.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:te,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let te=Ve.get(R);te.__webglFramebuffer=H,te.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,te=0){se=R,J=H,k=te;let Z=null,Q=!1,Ae=!1;if(R){let Ee=Ve.get(R);if(Ee.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(V.FRAMEBUFFER,Ee.__webglFramebuffer),q.copy(R.viewport),ie.copy(R.scissor),ne=R.scissorTest,we.viewport(q),we.scissor(ie),we.setScissorTest(ne),Y=-1;return}else if(Ee.__webglFramebuffer===void 0)qe.setupRenderTarget(R);else if(Ee.__hasExternalTextures)qe.rebindTextures(R,Ve.get(R.texture).__webglTexture,Ve.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let et=R.depthTexture;if(Ee.__boundDepthTexture!==et){if(et!==null&&Ve.has(et)&&(R.width!==et.image.width||R.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(R)}}let Ie=R.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ae=!0);let ze=Ve.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(ze[H])?Z=ze[H][te]:Z=ze[H],Q=!0):R.samples>0&&qe.useMultisampledRTT(R)===!1?Z=Ve.get(R).__webglMultisampledFramebuffer:Array.isArray(ze)?Z=ze[te]:Z=ze,q.copy(R.viewport),ie.copy(R.scissor),ne=R.scissorTest}else q.copy(He).multiplyScalar(xe).floor(),ie.copy(ft).multiplyScalar(xe).floor(),ne=ct;if(te!==0&&(Z=B),we.bindFramebuffer(V.FRAMEBUFFER,Z)&&we.drawBuffers(R,Z),we.viewport(q),we.scissor(ie),we.setScissorTest(ne),Q){let Ee=Ve.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ee.__webglTexture,te)}else if(Ae){let Ee=H;for(let Ie=0;Ie<R.textures.length;Ie++){let ze=Ve.get(R.textures[Ie]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,te,Ee)}}else if(R!==null&&te!==0){let Ee=Ve.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Ee.__webglTexture,te)}Y=-1};function qr(R){let H=Ve.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=ot.textureFormatReadable(R.format),H.__typeReadable=ot.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,te,Z,Q,Ae,Pe,Ee=0){if(!(R&&R.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(V.FRAMEBUFFER,Ie);try{let ze=R.textures[Ee],et=ze.format,dt=ze.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Ee);let ke=qr(ze);if(ke.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Z&&te>=0&&te<=R.height-Q&&V.readPixels(H,te,Z,Q,ve.convert(et),ve.convert(dt),Ae)}finally{let ze=se!==null?Ve.get(se).__webglFramebuffer:null;we.bindFramebuffer(V.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(R,H,te,Z,Q,Ae,Pe,Ee=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(H>=0&&H<=R.width-Z&&te>=0&&te<=R.height-Q){we.bindFramebuffer(V.FRAMEBUFFER,Ie);let ze=R.textures[Ee],et=ze.format,dt=ze.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Ee);let ke=qr(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,pt),V.bufferData(V.PIXEL_PACK_BUFFER,Ae.byteLength,V.STREAM_READ),V.readPixels(H,te,Z,Q,ve.convert(et),ve.convert(dt),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Kt=se!==null?Ve.get(se).__webglFramebuffer:null;we.bindFramebuffer(V.FRAMEBUFFER,Kt);let Rt=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await c_(V,Rt,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,pt),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Ae),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(pt),V.deleteSync(Rt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,te=0){let Z=Math.pow(2,-te),Q=Math.floor(R.image.width*Z),Ae=Math.floor(R.image.height*Z),Pe=H!==null?H.x:0,Ee=H!==null?H.y:0;qe.setTexture2D(R,0),V.copyTexSubImage2D(V.TEXTURE_2D,te,0,0,Pe,Ee,Q,Ae),we.unbindTexture()},this.copyTextureToTexture=function(R,H,te=null,Z=null,Q=0,Ae=0){let Pe,Ee,Ie,ze,et,dt,ke,pt,Kt,Rt=R.isCompressedTexture?R.mipmaps[Ae]:R.image;if(te!==null)Pe=te.max.x-te.min.x,Ee=te.max.y-te.min.y,Ie=te.isBox3?te.max.z-te.min.z:1,ze=te.min.x,et=te.min.y,dt=te.isBox3?te.min.z:0;else{let ut=Math.pow(2,-Q);Pe=Math.floor(Rt.width*ut),Ee=Math.floor(Rt.height*ut),R.isDataArrayTexture?Ie=Rt.depth:R.isData3DTexture?Ie=Math.floor(Rt.depth*ut):Ie=1,ze=0,et=0,dt=0}Z!==null?(ke=Z.x,pt=Z.y,Kt=Z.z):(ke=0,pt=0,Kt=0);let Pt=ve.convert(H.format),gn=ve.convert(H.type),Fe;H.isData3DTexture?(qe.setTexture3D(H,0),Fe=V.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(qe.setTexture2DArray(H,0),Fe=V.TEXTURE_2D_ARRAY):(qe.setTexture2D(H,0),Fe=V.TEXTURE_2D),we.activeTexture(V.TEXTURE0),we.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,H.flipY),we.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),we.pixelStorei(V.UNPACK_ALIGNMENT,H.unpackAlignment);let ln=we.getParameter(V.UNPACK_ROW_LENGTH),_t=we.getParameter(V.UNPACK_IMAGE_HEIGHT),ps=we.getParameter(V.UNPACK_SKIP_PIXELS),cn=we.getParameter(V.UNPACK_SKIP_ROWS),Yr=we.getParameter(V.UNPACK_SKIP_IMAGES);we.pixelStorei(V.UNPACK_ROW_LENGTH,Rt.width),we.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Rt.height),we.pixelStorei(V.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(V.UNPACK_SKIP_ROWS,et),we.pixelStorei(V.UNPACK_SKIP_IMAGES,dt);let ji=R.isDataArrayTexture||R.isData3DTexture,ms=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let ut=Ve.get(R),en=Ve.get(H),Xn=Ve.get(ut.__renderTarget),It=Ve.get(en.__renderTarget);we.bindFramebuffer(V.READ_FRAMEBUFFER,Xn.__webglFramebuffer),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let un=0;un<Ie;un++)ji&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ve.get(R).__webglTexture,Q,dt+un),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ve.get(H).__webglTexture,Ae,Kt+un)),V.blitFramebuffer(ze,et,ze+Pe,et+Ee,ke,pt,ke+Pe,pt+Ee,V.DEPTH_BUFFER_BIT,V.NEAREST);we.bindFramebuffer(V.READ_FRAMEBUFFER,null),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||Ve.has(R)){let ut=Ve.get(R),en=Ve.get(H);we.bindFramebuffer(V.READ_FRAMEBUFFER,D),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,G);for(let Xn=0;Xn<Ie;Xn++)ji?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ut.__webglTexture,Q,dt+Xn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ut.__webglTexture,Q),ms?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,en.__webglTexture,Ae,Kt+Xn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,en.__webglTexture,Ae),Q!==0?V.blitFramebuffer(ze,et,ze+Pe,et+Ee,ke,pt,ke+Pe,pt+Ee,V.COLOR_BUFFER_BIT,V.NEAREST):ms?V.copyTexSubImage3D(Fe,Ae,ke,pt,Kt+Xn,ze,et,Pe,Ee):V.copyTexSubImage2D(Fe,Ae,ke,pt,ze,et,Pe,Ee);we.bindFramebuffer(V.READ_FRAMEBUFFER,null),we.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else ms?R.isDataTexture||R.isData3DTexture?V.texSubImage3D(Fe,Ae,ke,pt,Kt,Pe,Ee,Ie,Pt,gn,Rt.data):H.isCompressedArrayTexture?V.compressedTexSubImage3D(Fe,Ae,ke,pt,Kt,Pe,Ee,Ie,Pt,Rt.data):V.texSubImage3D(Fe,Ae,ke,pt,Kt,Pe,Ee,Ie,Pt,gn,Rt):R.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Ae,ke,pt,Pe,Ee,Pt,gn,Rt.data):R.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Ae,ke,pt,Rt.width,Rt.height,Pt,Rt.data):V.texSubImage2D(V.TEXTURE_2D,Ae,ke,pt,Pe,Ee,Pt,gn,Rt);we.pixelStorei(V.UNPACK_ROW_LENGTH,ln),we.pixelStorei(V.UNPACK_IMAGE_HEIGHT,_t),we.pixelStorei(V.UNPACK_SKIP_PIXELS,ps),we.pixelStorei(V.UNPACK_SKIP_ROWS,cn),we.pixelStorei(V.UNPACK_SKIP_IMAGES,Yr),Ae===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&V.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(R){Ve.get(R).__webglFramebuffer===void 0&&qe.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?qe.setTextureCube(R,0):R.isData3DTexture?qe.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?qe.setTexture2DArray(R,0):qe.setTexture2D(R,0),we.unbindTexture()},this.resetState=function(){J=0,k=0,se=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var $i=new at,th=class extends Br{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,i,s){let r=this,o=new Qa(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},i,s)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(M,b=0){let y=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,S="",m=y.exec(M);m!==null&&(S=m[1]);let w={comments:[],elements:[],headerLength:b,objInfo:""},I=S.split(/\r\n|\r|\n/),P;function L(N,B){let D={type:N[0]};return D.type==="list"?(D.name=N[3],D.countType=N[1],D.itemType=N[2]):D.name=N[1],D.name in B&&(D.name=B[D.name]),D}for(let N=0;N<I.length;N++){let B=I[N];if(B=B.trim(),B==="")continue;let D=B.split(/\s+/),G=D.shift();switch(B=D.join(" "),G){case"format":w.format=D[0],w.version=D[1];break;case"comment":w.comments.push(B);break;case"element":P!==void 0&&w.elements.push(P),P={},P.name=D[0],P.count=parseInt(D[1]),P.properties=[];break;case"property":P.properties.push(L(D,x.propertyNameMapping));break;case"obj_info":w.objInfo=B;break;default:console.log("unhandled",G,D)}}return P!==void 0&&w.elements.push(P),w}function i(M,b){switch(b){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(M);case"float":case"double":case"float32":case"float64":return parseFloat(M)}}function s(M,b){let y={};for(let S=0;S<M.length;S++){if(b.empty())return null;if(M[S].type==="list"){let m=[],w=i(b.next(),M[S].countType);for(let I=0;I<w;I++){if(b.empty())return null;m.push(i(b.next(),M[S].itemType))}y[M[S].name]=m}else y[M[S].name]=i(b.next(),M[S].type)}return y}function r(){let M={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let b of Object.keys(x.customPropertyMapping))M[b]=[];return M}function o(M){switch(M){case"int8":case"char":return za;case"uint8":case"uchar":return Va;case"int16":case"short":return Ga;case"uint16":case"ushort":return Or;case"int32":case"int":return Ha;case"uint32":case"uint":return Fr;case"float32":case"float":return bn;case"float64":case"double":return kd}}function a(M){switch(M){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(M){return M==="float"||M==="float32"||M==="double"||M==="float64"}function c(M){function b(se){for(let Y of se){let K=M.find(q=>q.name===Y);if(K)return K}return null}let y=b(["x","px","posx"]),S=b(["y","py","posy"]),m=b(["z","pz","posz"]),w=b(["nx","normalx"]),I=b(["ny","normaly"]),P=b(["nz","normalz"]),L=b(["s","u","texture_u","tx"]),N=b(["t","v","texture_v","ty"]),B=b(["red","diffuse_red","r","diffuse_r"]),D=b(["green","diffuse_green","g","diffuse_g"]),G=b(["blue","diffuse_blue","b","diffuse_b"]),J=b(["texcoord"]),k={};for(let se of Object.keys(x.customPropertyMapping)){let K=x.customPropertyMapping[se].map(ne=>M.find(j=>j.name===ne)),q=K.filter(ne=>ne).map(ne=>ne.type),ie=q.length>0&&q.every(ne=>ne===q[0]);k[se]={type:ie?q[0]:"float32",usage:K.every(ne=>ne!==void 0)}}return{position:{names:[y?y.name:"x",S?S.name:"y",m?m.name:"z"],type:y?y.type:"float32",usage:!!(y&&S&&m)},normal:{names:[w?w.name:"nx",I?I.name:"ny",P?P.name:"nz"],type:w?w.type:"float32",usage:!!(w&&I&&P)},uv:{names:[L?L.name:"s",N?N.name:"t"],type:L?L.type:"float32",usage:!!(L&&N)},texcoord:{type:J?J.itemType:"float32",usage:!!J},color:{names:[B?B.name:"red",D?D.name:"green",G?G.name:"blue"],type:B?B.type:"uchar",usage:!!(B&&D&&G)},custom:k}}function u(M,b){let y=r(),S=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,m,w;(w=S.exec(M))!==null?m=w[1].split(/\s+/):m=[];let I=new zd(m);e:for(let P=0;P<b.elements.length;P++){let L=b.elements[P],N=c(L.properties);y.descriptors[L.name]=N;for(let B=0;B<L.count;B++){let D=s(L.properties,I);if(!D)break e;f(y,L.name,D,N)}}return h(y)}function h(M){let b=new ni,y=M.descriptors.vertex;M.indices.length>0&&b.setIndex(M.indices);let S=o(y?y.position.type:"float32");if(b.setAttribute("position",new S(M.vertices,3)),M.normals.length>0){let m=o(y.normal.type);b.setAttribute("normal",new m(M.normals,3))}if(M.uvs.length>0){let m=o(y.uv.type);b.setAttribute("uv",new m(M.uvs,2))}if(M.colors.length>0){let m=y.color.type,w=!l(m),I=o(m);b.setAttribute("color",new I(M.colors,3,w))}for(let m of Object.keys(x.customPropertyMapping))if(M[m].length>0){let w=o(y.custom[m].type);b.setAttribute(m,new w(M[m],x.customPropertyMapping[m].length))}if(M.faceVertexUvs.length>0||M.faceVertexColors.length>0){if(b=b.toNonIndexed(),M.faceVertexUvs.length>0){let m=o(M.descriptors.face.texcoord.type);b.setAttribute("uv",new m(M.faceVertexUvs,2))}if(M.faceVertexColors.length>0){let m=M.descriptors.face.color.type,w=!l(m),I=o(m);b.setAttribute("color",new I(M.faceVertexColors,3,w))}}return b.computeBoundingSphere(),b}function f(M,b,y,S){if(b==="vertex"){let{position:m,normal:w,uv:I,color:P}=S;if(m.usage&&M.vertices.push(y[m.names[0]],y[m.names[1]],y[m.names[2]]),w.usage&&M.normals.push(y[w.names[0]],y[w.names[1]],y[w.names[2]]),I.usage&&M.uvs.push(y[I.names[0]],y[I.names[1]]),P.usage){let L=a(P.type),N=l(P.type);$i.setRGB(y[P.names[0]]*L,y[P.names[1]]*L,y[P.names[2]]*L,Gn);let B=1/L;M.colors.push(N?$i.r:Math.round($i.r*B),N?$i.g:Math.round($i.g*B),N?$i.b:Math.round($i.b*B))}for(let L of Object.keys(x.customPropertyMapping))for(let N of x.customPropertyMapping[L])M[L].push(y[N])}else if(b==="face"){let m=y.vertex_indices||y.vertex_index,w=y.texcoord;m.length===3?(M.indices.push(m[0],m[1],m[2]),w&&w.length===6&&(M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[2],w[3]),M.faceVertexUvs.push(w[4],w[5]))):m.length===4&&(M.indices.push(m[0],m[1],m[2]),M.indices.push(m[0],m[2],m[3]),w&&w.length===8&&(M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[2],w[3]),M.faceVertexUvs.push(w[4],w[5]),M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[4],w[5]),M.faceVertexUvs.push(w[6],w[7])));let{color:I}=S;if(I.usage){let P=a(I.type);$i.setRGB(y[I.names[0]]*P,y[I.names[1]]*P,y[I.names[2]]*P,Gn);let L=1/P,N=$i.r*L,B=$i.g*L,D=$i.b*L;M.faceVertexColors.push(N,B,D),M.faceVertexColors.push(N,B,D),M.faceVertexColors.push(N,B,D),m.length===4&&(M.faceVertexColors.push(N,B,D),M.faceVertexColors.push(N,B,D),M.faceVertexColors.push(N,B,D))}}}function d(M,b){let y={},S=0;for(let m=0;m<b.length;m++){let w=b[m],I=w.valueReader;if(w.type==="list"){let P=[],L=w.countReader.read(M+S);S+=w.countReader.size;for(let N=0;N<L;N++)P.push(I.read(M+S)),S+=I.size;y[w.name]=P}else y[w.name]=I.read(M+S),S+=I.size}return[y,S]}function _(M,b,y){function S(m,w,I){switch(w){case"int8":case"char":return{read:P=>m.getInt8(P),size:1};case"uint8":case"uchar":return{read:P=>m.getUint8(P),size:1};case"int16":case"short":return{read:P=>m.getInt16(P,I),size:2};case"uint16":case"ushort":return{read:P=>m.getUint16(P,I),size:2};case"int32":case"int":return{read:P=>m.getInt32(P,I),size:4};case"uint32":case"uint":return{read:P=>m.getUint32(P,I),size:4};case"float32":case"float":return{read:P=>m.getFloat32(P,I),size:4};case"float64":case"double":return{read:P=>m.getFloat64(P,I),size:8}}}for(let m=0,w=M.length;m<w;m++){let I=M[m];I.type==="list"?(I.countReader=S(b,I.countType,y),I.valueReader=S(b,I.itemType,y)):I.valueReader=S(b,I.type,y)}}function v(M,b){let y=r(),S=b.format==="binary_little_endian",m=new DataView(M,b.headerLength),w,I=0;for(let P=0;P<b.elements.length;P++){let L=b.elements[P],N=L.properties,B=c(N);y.descriptors[L.name]=B,_(N,m,S);for(let D=0;D<L.count;D++){w=d(I,N),I+=w[1];let G=w[0];f(y,L.name,G,B)}}return h(y)}function p(M){let b=0,y=!0,S="",m=[],w=new TextDecoder().decode(M.subarray(0,5)),I=/^ply\r\n/.test(w);do{let P=String.fromCharCode(M[b++]);P!==`
`&&P!=="\r"?S+=P:(S==="end_header"&&(y=!1),S!==""&&(m.push(S),S=""))}while(y&&b<M.length);return I===!0&&b++,{headerText:m.join("\r")+"\r",headerLength:b}}let g,x=this;if(e instanceof ArrayBuffer){let M=new Uint8Array(e),{headerText:b,headerLength:y}=p(M),S=t(b,y);if(S.format==="ascii"){let m=new TextDecoder().decode(M);g=u(m,S)}else g=v(e,S)}else g=u(e,t(e));return g}},kd=class extends Zt{constructor(e,t,i){super(new Float64Array(e),t,i)}},zd=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function xl(n){for(var e=n.length/6|0,t=new Array(e),i=0;i<e;)t[i]="#"+n.slice(i*6,++i*6);return t}function Vd(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-n*(35.34-n*(2381.73-n*(6402.7-n*(7024.72-n*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+n*(170.73+n*(52.82-n*(131.46-n*(176.58-n*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+n*(442.36-n*(2482.43-n*(6167.24-n*(6614.94-n*2475.67)))))))+")"}function nh(n){var e=n.length;return function(t){return n[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var Gd=nh(xl("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),VT=nh(xl("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),GT=nh(xl("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),HT=nh(xl("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function WT(n){let e=/^#(..)(..)(..)$/.exec(n),t=e?e.slice(1).map(i=>parseInt(i,16)):(n.match(/[\d.]+/g)??[]).map(Number);return[t[0]??0,t[1]??0,t[2]??0]}var Ji=256;function vl(n){let e=n==="viridis"?Gd:Vd,t=new Uint8Array(4*Ji);for(let i=0;i<Ji;i++)t.set([...WT(e(i/(Ji-1))),255],4*i);return t}var Us=[{name:"no outlier",color:[208,212,218]},{name:"too far away after registration",color:[230,159,0]},{name:"its neighbors map elsewhere",color:[0,114,178]},{name:"both",color:[213,94,0]},{name:"the target has nothing there",color:[86,60,92]}];function J_(){let n=new Uint8Array(4*Ji);for(let e=0;e<Ji;e++){let t=Us[Math.min(Us.length-1,Math.floor(e/Ji*Us.length))];n.set([...t?.color??[0,0,0],255],4*e)}return n}var Z_=([n,e,t])=>`rgb(${n}, ${e}, ${t})`,K_=n=>(n+.5)/Us.length;function ih(n,e=[]){let t=new th,i=new TextDecoder().decode(n.slice(0,4096)).split("end_header")[0]??"",s=e.filter(a=>new RegExp(`^property \\w+ ${a}\\s*$`,"m").test(i));t.setCustomPropertyNameMapping(Object.fromEntries(s.map(a=>[a,[a]])));let r=t.parse(n),o={};for(let a of s)o[a]=Float32Array.from(r.getAttribute(a).array),r.deleteAttribute(a);return r.setAttribute("position",new Zt(Float32Array.from(r.getAttribute("position").array),3)),r.computeVertexNormals(),r.computeBoundingSphere(),{geometry:r,rows:o}}var XT=["target","confidence","inlier","spread_mm","outlier","triangle_0","triangle_1","triangle_2","barycentric_0","barycentric_1","barycentric_2"];async function j_(n,e){let t=`v1/jobs/${n.id}`,i=async a=>(await bi(`${t}/${a}`,{signal:e})).arrayBuffer(),[s,r,o]=await Promise.all([br(()=>Ut(`${t}/result?correspondences=false`,e),e),br(()=>i("correspondences?format=ply"),e),br(()=>i("surfaces/target?format=ply"),e)]);return{pair:qT(s,r,o),result:s}}function qT(n,e,t){let{geometry:i,rows:s}=ih(e,XT),{geometry:r}=ih(t),o=i.getAttribute("position").count,a=new Float32Array(o),l=N=>s[N]??a,[c,u]=[i.getAttribute("position"),r.getAttribute("position")],h=n.transform.matrix.flat(),f=new gt().set(...h),d=[l("triangle_0"),l("triangle_1"),l("triangle_2")],_=[l("barycentric_0"),l("barycentric_1"),l("barycentric_2")],v=new Float32Array(3*o),p=new Int32Array(o),g=l("outlier"),x={confidence:new Float32Array(o),residual:new Float32Array(o),displacement:new Float32Array(o),spread:new Float32Array(o),outlier:new Float32Array(o)},[M,b,y]=[new X,new X,i.getAttribute("normal")];for(let N=0;N<o;N++){let B=g[N]===4;for(let D=0;D<3;D++){let G=0;for(let J=0;J<3;J++)G+=(_[J]?.[N]??0)*u.getComponent(d[J]?.[N]??0,D);v[3*N+D]=G}p[N]=B?-1:l("target")[N]??-1,M.fromBufferAttribute(c,N).applyMatrix4(f),b.fromBufferAttribute(y,N).transformDirection(f),M.set(v[3*N]-M.x,v[3*N+1]-M.y,v[3*N+2]-M.z),x.confidence[N]=B?NaN:l("confidence")[N]??NaN,x.spread[N]=B?NaN:l("spread_mm")[N]??NaN,x.residual[N]=B?NaN:M.length(),x.displacement[N]=B?NaN:M.dot(b),x.outlier[N]=K_(g[N]??0)}let S=Object.fromEntries(Object.keys(x).map(N=>[N,YT(x[N],N==="outlier",d,_,p,r)])),m=u.count,w=new Uint32Array(m+1);p.forEach(N=>N>=0&&w[N+1]++);for(let N=0;N<m;N++)w[N+1]+=w[N];let I=w.slice(0,m),P=new Uint32Array(w[m]);p.forEach((N,B)=>N>=0&&(P[I[N]++]=B));let L=Uint8Array.from(l("inlier"));return{source:i,target:r,targetFromSource:f,images:v,nearest:p,inlier:L,columns:x,onTarget:S,starts:w,sources:P,frame:Hd(r)}}function YT(n,e,t,i,s,r){let o=r.getAttribute("position").count,a=new Float32Array(o).fill(NaN);if(e)s.forEach((c,u)=>c>=0&&(a[c]=Math.max(Number.isNaN(a[c])?0:a[c],n[u])));else{let[c,u]=[new Float64Array(o),new Float64Array(o)];for(let h=0;h<n.length;h++)if(!Number.isNaN(n[h]))for(let f=0;f<3;f++){let[d,_]=[t[f][h],i[f][h]];c[d]+=_*n[h],u[d]+=_}for(let h=0;h<o;h++)u[h]>1e-9&&(a[h]=c[h]/u[h])}let l=r.getIndex();for(let c=0;c<2;c++){let[u,h]=[new Float64Array(o),new Uint16Array(o)];for(let f=0;f<l.count;f+=3)for(let d=0;d<3;d++){let _=a[l.getX(f+d)];if(!Number.isNaN(_))for(let v=0;v<3;v++){let p=l.getX(f+v);u[p]=e?Math.max(u[p],_):u[p]+_,h[p]++}}for(let f=0;f<o;f++)Number.isNaN(a[f])&&h[f]>0&&(a[f]=e?u[f]:u[f]/h[f])}return a}function Hd(n){let e=n.getAttribute("position"),t=new X,i=new X;for(let _=0;_<e.count;_++)t.add(i.fromBufferAttribute(e,_));t.divideScalar(Math.max(1,e.count));let s=[0,0,0,0,0,0,0,0,0];for(let _=0;_<e.count;_++){let v=i.fromBufferAttribute(e,_).sub(t).toArray();for(let p=0;p<3;p++)for(let g=0;g<3;g++)s[3*p+g]+=v[p]*v[g]}let r=[1,0,0,0,1,0,0,0,1];for(let _=0;_<12;_++)for(let[v,p]of[[0,1],[0,2],[1,2]]){let g=s[3*v+p];if(Math.abs(g)<1e-12)continue;let x=.5*Math.atan2(2*g,s[3*p+p]-s[3*v+v]),[M,b]=[Math.cos(x),Math.sin(x)];for(let y=0;y<3;y++){let[S,m]=[s[3*y+v],s[3*y+p]];s[3*y+v]=M*S-b*m,s[3*y+p]=b*S+M*m}for(let y=0;y<3;y++){let[S,m]=[s[3*v+y],s[3*p+y]];s[3*v+y]=M*S-b*m,s[3*p+y]=b*S+M*m;let[w,I]=[r[3*y+v],r[3*y+p]];r[3*y+v]=M*w-b*I,r[3*y+p]=b*w+M*I}}let o=[0,1,2].sort((_,v)=>s[4*v]-s[4*_]),a=_=>new X(r[o[_]],r[3+o[_]],r[6+o[_]]).normalize(),[l,c]=[a(0),a(1)],u=[l,c,new X().crossVectors(l,c)],[h,f]=[new X(1/0,1/0,1/0),new X(-1/0,-1/0,-1/0)],d=new X;for(let _=0;_<e.count;_++)i.fromBufferAttribute(e,_).sub(t),d.set(i.dot(u[0]),i.dot(u[1]),i.dot(u[2])),h.min(d),f.max(d);return{center:t,axes:u,low:h,high:f}}function Wd(n,e,t){let i=e.length/3,s=new Float32Array(3*i),r=new X,o=Math.max(1e-9,n.high.x-n.low.x);for(let a=0;a<i;a++)r.set(e[3*a],e[3*a+1],e[3*a+2]).sub(n.center),s[3*a]=t(a)?(r.dot(n.axes[0])-n.low.x)/o:-1,s[3*a+1]=r.dot(n.axes[1]),s[3*a+2]=r.dot(n.axes[2]);return new Zt(s,3)}function Q_(n,e){let t=n.filter(i=>!Number.isNaN(i)).sort();return t[Math.min(t.length-1,Math.floor(e*t.length))]??1}var Xd={type:"change"},$d={type:"start"},Jd={type:"end"},sh=1e-6,At={NONE:-1,ROTATE:0,ZOOM:1,PAN:2,TOUCH_ROTATE:3,TOUCH_ZOOM_PAN:4},rh=new tt,hr=new tt,$T=new X,oh=new X,qd=new X,fr=new Un,ah=new X,lh=new X,Yd=new X,ch=new X,Qo=class extends rl{constructor(e,t=null){super(e,t),this.screen={left:0,top:0,width:0,height:0},this.rotateSpeed=1,this.zoomSpeed=1.2,this.panSpeed=.3,this.rollSpeed=1,this.noRotate=!1,this.noZoom=!1,this.noPan=!1,this.multiTouchRoll=!1,this.staticMoving=!1,this.dynamicDampingFactor=.2,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.keys=["KeyA","KeyS","KeyD"],this.mouseButtons={LEFT:lr.ROTATE,MIDDLE:lr.DOLLY,RIGHT:lr.PAN},this.target=new X,this.state=At.NONE,this.keyState=At.NONE,this._lastPosition=new X,this._lastUp=new X,this._lastZoom=1,this._touchZoomDistanceStart=0,this._touchZoomDistanceEnd=0,this._touchRollAngle=0,this._touchRollPointerIds="",this._lastAngle=0,this._lastRollAngle=0,this._eye=new X,this._movePrev=new tt,this._moveCurr=new tt,this._lastAxis=new X,this._zoomStart=new tt,this._zoomEnd=new tt,this._panStart=new tt,this._panEnd=new tt,this._pointers=[],this._pointerPositions={},this._onPointerMove=ZT.bind(this),this._onPointerDown=JT.bind(this),this._onPointerUp=KT.bind(this),this._onPointerCancel=jT.bind(this),this._onContextMenu=rA.bind(this),this._onMouseWheel=sA.bind(this),this._onKeyDown=eA.bind(this),this._onKeyUp=QT.bind(this),this._onTouchStart=oA.bind(this),this._onTouchMove=aA.bind(this),this._onTouchEnd=lA.bind(this),this._onMouseDown=tA.bind(this),this._onMouseMove=nA.bind(this),this._onMouseUp=iA.bind(this),this._target0=this.target.clone(),this._position0=this.object.position.clone(),this._up0=this.object.up.clone(),this._zoom0=this.object.zoom,t!==null&&(this.connect(t),this.handleResize()),this.update()}connect(e){super.connect(e),window.addEventListener("keydown",this._onKeyDown),window.addEventListener("keyup",this._onKeyUp),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerCancel),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction="none"}disconnect(){window.removeEventListener("keydown",this._onKeyDown),window.removeEventListener("keyup",this._onKeyUp),this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerCancel),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction=""}dispose(){this.disconnect()}handleResize(){let e=this.domElement.getBoundingClientRect(),t=this.domElement.ownerDocument.documentElement;this.screen.left=e.left+window.pageXOffset-t.clientLeft,this.screen.top=e.top+window.pageYOffset-t.clientTop,this.screen.width=e.width,this.screen.height=e.height}update(){if(this._eye.subVectors(this.object.position,this.target),this.noRotate||(this._rotateCamera(),this.multiTouchRoll===!0&&this._rollCamera()),this.noZoom||this._zoomCamera(),this.noPan||this._panCamera(),this.object.position.addVectors(this.target,this._eye),this.object.isPerspectiveCamera){this._checkDistances(),this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>sh,t=this._lastUp.distanceToSquared(this.object.up)>sh;(e||t)&&(this.dispatchEvent(Xd),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up))}else if(this.object.isOrthographicCamera){this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>sh,t=this._lastUp.distanceToSquared(this.object.up)>sh,i=this._lastZoom!==this.object.zoom;(e||t||i)&&(this.dispatchEvent(Xd),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom)}else console.warn("THREE.TrackballControls: Unsupported camera type.")}reset(){this.state=At.NONE,this.keyState=At.NONE,this.target.copy(this._target0),this.object.position.copy(this._position0),this.object.up.copy(this._up0),this.object.zoom=this._zoom0,this.object.updateProjectionMatrix(),this._eye.subVectors(this.object.position,this.target),this.object.lookAt(this.target),this.dispatchEvent(Xd),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom}_panCamera(){if(hr.copy(this._panEnd).sub(this._panStart),hr.lengthSq()){if(this.object.isOrthographicCamera){let e=(this.object.right-this.object.left)/this.object.zoom/this.domElement.clientWidth,t=(this.object.top-this.object.bottom)/this.object.zoom/this.domElement.clientWidth;hr.x*=e,hr.y*=t}hr.multiplyScalar(this._eye.length()*this.panSpeed),oh.copy(this._eye).cross(this.object.up).setLength(hr.x),oh.add($T.copy(this.object.up).setLength(hr.y)),this.object.position.add(oh),this.target.add(oh),this.staticMoving?this._panStart.copy(this._panEnd):this._panStart.add(hr.subVectors(this._panEnd,this._panStart).multiplyScalar(this.dynamicDampingFactor))}}_rotateCamera(){ch.set(this._moveCurr.x-this._movePrev.x,this._moveCurr.y-this._movePrev.y,0);let e=ch.length();e?(this._eye.copy(this.object.position).sub(this.target),ah.copy(this._eye).normalize(),lh.copy(this.object.up).normalize(),Yd.crossVectors(lh,ah).normalize(),lh.setLength(this._moveCurr.y-this._movePrev.y),Yd.setLength(this._moveCurr.x-this._movePrev.x),ch.copy(lh.add(Yd)),qd.crossVectors(ch,this._eye).normalize(),e*=this.rotateSpeed,fr.setFromAxisAngle(qd,e),this._eye.applyQuaternion(fr),this.object.up.applyQuaternion(fr),this._lastAxis.copy(qd),this._lastAngle=e):!this.staticMoving&&this._lastAngle&&(this._lastAngle*=Math.sqrt(1-this.dynamicDampingFactor),this._eye.copy(this.object.position).sub(this.target),fr.setFromAxisAngle(this._lastAxis,this._lastAngle),this._eye.applyQuaternion(fr),this.object.up.applyQuaternion(fr)),this._movePrev.copy(this._moveCurr)}_rollCamera(){let e=this._getTouchRollAngle();if(e)this._lastRollAngle=e*this.rollSpeed;else if(!this.staticMoving&&this._lastRollAngle)this._lastRollAngle*=Math.sqrt(1-this.dynamicDampingFactor);else return;ah.copy(this._eye).normalize(),fr.setFromAxisAngle(ah,this._lastRollAngle),this.object.up.applyQuaternion(fr)}_getTouchRollAngle(){let e=this._pointers[0],t=this._pointers[1];if(t===void 0||e.pointerType!=="touch"||t.pointerType!=="touch")return this._touchRollPointerIds="",0;let i=`${e.pointerId},${t.pointerId}`,s=this._pointerPositions[e.pointerId],r=this._pointerPositions[t.pointerId],o=Math.atan2(r.y-s.y,r.x-s.x);if(i!==this._touchRollPointerIds)return this._touchRollPointerIds=i,this._touchRollAngle=o,0;let a=o-this._touchRollAngle;return this._touchRollAngle=o,a>Math.PI?a-=2*Math.PI:a<-Math.PI&&(a+=2*Math.PI),a}_zoomCamera(){let e;this.state===At.TOUCH_ZOOM_PAN?(e=this._touchZoomDistanceStart/this._touchZoomDistanceEnd,this._touchZoomDistanceStart=this._touchZoomDistanceEnd,this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=Ju.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")):(e=1+(this._zoomEnd.y-this._zoomStart.y)*this.zoomSpeed,e!==1&&e>0&&(this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=Ju.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")),this.staticMoving?this._zoomStart.copy(this._zoomEnd):this._zoomStart.y+=(this._zoomEnd.y-this._zoomStart.y)*this.dynamicDampingFactor)}_getMouseOnScreen(e,t){return rh.set((e-this.screen.left)/this.screen.width,(t-this.screen.top)/this.screen.height),rh}_getMouseOnCircle(e,t){return rh.set((e-this.screen.width*.5-this.screen.left)/(this.screen.width*.5),(this.screen.height+2*(this.screen.top-t))/this.screen.width),rh}_addPointer(e){this._pointers.push(e)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t].pointerId==e.pointerId){this._pointers.splice(t,1);return}}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0].pointerId?this._pointers[1]:this._pointers[0];return this._pointerPositions[t.pointerId]}_checkDistances(){(!this.noZoom||!this.noPan)&&(this._eye.lengthSq()>this.maxDistance*this.maxDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.maxDistance)),this._zoomStart.copy(this._zoomEnd)),this._eye.lengthSq()<this.minDistance*this.minDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.minDistance)),this._zoomStart.copy(this._zoomEnd)))}};function JT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n))}function ZT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function KT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchEnd(n):this._onMouseUp(),this._removePointer(n),this._pointers.length===0&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp)))}function jT(n){this._removePointer(n)}function QT(){this.enabled!==!1&&(this.keyState=At.NONE,window.addEventListener("keydown",this._onKeyDown))}function eA(n){this.enabled!==!1&&(window.removeEventListener("keydown",this._onKeyDown),this.keyState===At.NONE&&(n.code===this.keys[At.ROTATE]&&!this.noRotate?this.keyState=At.ROTATE:n.code===this.keys[At.ZOOM]&&!this.noZoom?this.keyState=At.ZOOM:n.code===this.keys[At.PAN]&&!this.noPan&&(this.keyState=At.PAN)))}function tA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case lr.DOLLY:this.state=At.ZOOM;break;case lr.ROTATE:this.state=At.ROTATE;break;case lr.PAN:this.state=At.PAN;break;default:this.state=At.NONE}let t=this.keyState!==At.NONE?this.keyState:this.state;t===At.ROTATE&&!this.noRotate?(this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr)):t===At.ZOOM&&!this.noZoom?(this._zoomStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._zoomEnd.copy(this._zoomStart)):t===At.PAN&&!this.noPan&&(this._panStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._panEnd.copy(this._panStart)),this.dispatchEvent($d)}function nA(n){let e=this.keyState!==At.NONE?this.keyState:this.state;e===At.ROTATE&&!this.noRotate?this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)):e===At.ZOOM&&!this.noZoom?this._zoomEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY)):e===At.PAN&&!this.noPan&&this._panEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY))}function iA(){this.state=At.NONE,this.dispatchEvent(Jd)}function sA(n){if(this.enabled!==!1&&this.noZoom!==!0){switch(n.preventDefault(),n.deltaMode){case 2:this._zoomStart.y-=n.deltaY*.025;break;case 1:this._zoomStart.y-=n.deltaY*.01;break;default:this._zoomStart.y-=n.deltaY*25e-5;break}this.dispatchEvent($d),this.dispatchEvent(Jd)}}function rA(n){this.enabled!==!1&&n.preventDefault()}function oA(n){if(this._trackPointer(n),this._pointers.length===1)this.state=At.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(this._pointers[0].pageX,this._pointers[0].pageY)),this._movePrev.copy(this._moveCurr);else{this.state=At.TOUCH_ZOOM_PAN;let e=this._pointers[0].pageX-this._pointers[1].pageX,t=this._pointers[0].pageY-this._pointers[1].pageY;this._touchZoomDistanceEnd=this._touchZoomDistanceStart=Math.sqrt(e*e+t*t);let i=(this._pointers[0].pageX+this._pointers[1].pageX)/2,s=(this._pointers[0].pageY+this._pointers[1].pageY)/2;this._panStart.copy(this._getMouseOnScreen(i,s)),this._panEnd.copy(this._panStart)}this.dispatchEvent($d)}function aA(n){if(this._trackPointer(n),this._pointers.length===1)this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY));else{let e=this._getSecondPointerPosition(n),t=n.pageX-e.x,i=n.pageY-e.y;this._touchZoomDistanceEnd=Math.sqrt(t*t+i*i);let s=(n.pageX+e.x)/2,r=(n.pageY+e.y)/2;this._panEnd.copy(this._getMouseOnScreen(s,r))}}function lA(n){switch(this._pointers.length){case 0:this.state=At.NONE;break;case 1:this.state=At.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr);break;case 2:this.state=At.TOUCH_ZOOM_PAN;for(let e=0;e<this._pointers.length;e++)if(this._pointers[e].pointerId!==n.pointerId){let t=this._pointerPositions[this._pointers[e].pointerId];this._moveCurr.copy(this._getMouseOnCircle(t.x,t.y)),this._movePrev.copy(this._moveCurr);break}break}this.dispatchEvent(Jd)}var cA=`
  attribute float value;
  attribute vec3 place;
  uniform mat4 pose;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  void main() {
    vValue = value;
    vPlace = place;
    vNormal = normalMatrix * normal;
    vPosed = (pose * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`,uA=`
  uniform sampler2D map;
  uniform float low;
  uniform float top;
  uniform float opacity;
  uniform bool byPlace;
  uniform bool grid;
  uniform vec4 section;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  float line(float at) {
    float width = fwidth(at);
    float off = abs(fract(at - 0.5) - 0.5);
    return width > 0.4 ? 0.0 : 1.0 - smoothstep(width, 2.0 * width, off);
  }
  void main() {
    if (dot(vPosed, section.xyz) > section.w) discard;
    float at = byPlace ? vPlace.x : (vValue - low) / (top - low);
    bool isKnown = byPlace ? vPlace.x > -0.001 : vValue > -1e8;
    vec3 color = !isKnown ? vec3(0.62, 0.64, 0.66) : texture2D(map, vec2(clamp(at, 0.002, 0.998), 0.5)).rgb;
    if (grid && vPlace.x > -0.5) {
      float around = atan(vPlace.z, vPlace.y) * 1.2732395;
      float cut = abs(vPlace.z) < 1e-6 ? 0.0 : 1.0;
      float lines = max(line(vPlace.x * 12.0), fwidth(around) > 1.0 ? 0.0 : cut * line(around));
      color *= 1.0 - 0.55 * lines;
    }
    float light = 0.42 + 0.58 * abs(normalize(vNormal).z);
    if (!gl_FrontFacing) color = mix(color, vec3(0.45), 0.6);
    gl_FragColor = vec4(color * light, opacity);
  }`,ex=new zt(0,0,0,1),hA=240,Zd=64,fA=45,tx=250,Kd=56;function dA(n){n.computeBoundingBox();let{min:e,max:t}=n.boundingBox,i=Math.max(t.x-e.x,t.y-e.y,t.z-e.z,1e-9)/Kd,s=n.getAttribute("position"),r=new Map,o=new Uint32Array(s.count);for(let c=0;c<s.count;c++){let[u,h,f]=[(s.getX(c)-e.x)/i,(s.getY(c)-e.y)/i,(s.getZ(c)-e.z)/i].map(Math.floor),d=(u*(Kd+1)+h)*(Kd+1)+f,_=r.get(d);_===void 0&&r.set(d,c),o[c]=_??c}let a=n.getIndex(),l=[];for(let c=0;c<a.count;c+=3){let[u,h,f]=[o[a.getX(c)],o[a.getX(c+1)],o[a.getX(c+2)]];u!==h&&h!==f&&u!==f&&l.push(u,h,f)}return new Zt(Uint32Array.from(l),1)}var uh=class{constructor(e,t,i){this.canvas=e;this.pair=t;this.look=i,this.renderer=new Ko({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.renderer.autoClear=!1;let s=p=>{let g=new Ur(p,Ji,1);return g.needsUpdate=!0,g};this.maps={viridis:s(vl("viridis")),cividis:s(vl("cividis")),outlier:s(J_())};let{frame:r}=t,o=t.target.getAttribute("position").array;t.target.setAttribute("place",Wd(r,o,()=>!0)),t.source.setAttribute("place",Wd(r,t.images,p=>t.nearest[p]>=0)),this.indices={source:{whole:t.source.getIndex()},target:{whole:t.target.getIndex()}},this.meshes={source:this.surface(t.source),target:this.surface(t.target)};let a=Math.max(1e-6,r.high.x-r.low.x),l=new sr(a*.009,16,12);this.marks={source:this.marksOf(l),target:this.marksOf(l)},this.halos={source:this.halo(),target:this.halo()};for(let p of["source","target"])this.groups[p].add(this.meshes[p],this.marks[p],this.halos[p]),this.scene.add(this.groups[p]);this.radius=t.target.boundingSphere.radius;let c=t.source.boundingSphere.center.clone();this.centers={source:c,moved:c.clone().applyMatrix4(t.targetFromSource)};let u=[];t.inlier.forEach((p,g)=>p&&t.nearest[g]>=0&&u.push(g));let h=Math.max(1,Math.floor(u.length/hA));this.lineRows=u.filter((p,g)=>g%h===0);let f=new ni;f.setAttribute("position",new Zt(new Float32Array(6*this.lineRows.length),3)),this.lines=new qa(f,new Go({transparent:!0,opacity:.55,depthTest:!1})),this.lines.frustumCulled=!1,this.scene.add(this.lines),this.controls=new Qo(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.zoomSpeed=1.4,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.set(i),this.sizes.observe(e);let d=0,_=0,v=p=>{this.waiting=requestAnimationFrame(v),this.controls.update();let g=p-d;d=p,this.isDirty?(p-_<1e3&&_>0&&g>fA&&(this.isSlow=!0),this.detail(!(this.isSlow&&p-_<tx)),_=p,this.draw()):!this.isWhole&&p-_>tx&&(this.detail(!0),this.draw())};v(performance.now())}canvas;pair;renderer;camera=new Ds(-1,1,1,-1,-1e3,1e3);controls;scene=new Nr;groups={source:new as,target:new as};meshes;marks;halos;lines;lineRows;pose=new gt;centers;maps;sizes=new ResizeObserver(()=>this.resize());look;isSlow=!1;isWhole=!0;indices;waiting=0;isDirty=!0;radius;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.pair.source.dispose(),this.pair.target.dispose()}surface(e){e.setAttribute("value",new Zt(new Float32Array(e.getAttribute("position").count),1));let t={map:{value:this.maps.viridis},low:{value:0},top:{value:1},opacity:{value:1},byPlace:{value:!0},grid:{value:!0},section:{value:ex.clone()},pose:{value:new gt}},i=new Pi({vertexShader:cA,fragmentShader:uA,uniforms:t,side:ii}),s=new On(e,i);return s.matrixAutoUpdate=!1,s}detail(e){if(e!==this.isWhole){this.isWhole=e;for(let t of["source","target"]){let i=this.indices[t];i.coarse??=dA(this.pair[t]),this.pair[t].setIndex(e?i.whole:i.coarse)}}}marksOf(e){let t=new Xa(e,new Is({color:16723349,depthTest:!1}),Zd);return t.count=0,t.renderOrder=3,t.frustumCulled=!1,t}halo(){let e=new On(new sr(1,32,24),new Is({color:16723349,transparent:!0,opacity:.28,depthTest:!1}));return e.visible=!1,e.renderOrder=2,e}view(){let{center:e,axes:t}=this.pair.frame;this.controls.target.copy(e),this.camera.up.copy(t[1]),this.camera.position.copy(e).addScaledVector(t[2],4*this.radius),this.camera.near=-20*this.radius,this.camera.far=40*this.radius,this.camera.zoom=1,this.camera.lookAt(e),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new X().crossVectors(this.camera.up,i).normalize(),r=new Un().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new Un().setFromAxisAngle(s,t)),i.applyQuaternion(r),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}set(e){let{pair:t}=this;this.look=e;let i=e.coloring==="outlier"?this.maps.outlier:this.maps[e.map];for(let r of["source","target"]){let{uniforms:o}=this.meshes[r].material;if(o.map.value=i,o.byPlace.value=e.coloring==="correspondence",o.grid.value=e.grid&&e.coloring==="correspondence",o.low.value=e.coloring==="displacement"?-e.top:0,o.top.value=e.coloring==="outlier"?1:Math.max(1e-9,e.top),e.coloring!=="correspondence"){let a=r==="source"?t.columns[e.coloring]:t.onTarget[e.coloring],l=this.meshes[r].geometry.getAttribute("value");for(let c=0;c<a.length;c++)l.array[c]=Number.isNaN(a[c])?-1e9:a[c];l.needsUpdate=!0}}let s=this.meshes.source.material;s.transparent=e.overlay&&e.opacity<1,s.depthWrite=!s.transparent,s.uniforms.opacity.value=e.overlay?e.opacity:1,this.meshes.source.renderOrder=1,this.move(),this.resize()}move(){let[e,t,i]=[new X,new Un,new X];this.pair.targetFromSource.decompose(e,t,i);let s=this.look.pose,r=new Un().slerp(t,s),o=new X(1,1,1).lerp(i,s),a=this.centers.source.clone().lerp(this.centers.moved,s),l=new gt().compose(new X,r,o);e.copy(a).sub(this.centers.source.clone().applyMatrix4(l)),this.pose.compose(e,r,o),this.meshes.source.matrix.copy(s===1?this.pair.targetFromSource:this.pose),this.pose.copy(this.meshes.source.matrix),this.meshes.source.material.uniforms.pose.value.copy(this.pose),this.redraw()}isStacked(){return this.canvas.clientWidth<1.25*this.canvas.clientHeight}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(e===0||t===0)return;this.renderer.setSize(e,t,!1);let i=this.look.overlay?1:2,s=this.isStacked(),[r,o]=[s?e:e/i,s?t/i:t],{low:a,high:l}=this.pair.frame,[c,u]=[2.2*Math.max(-a.x,l.x),2.3*Math.max(-a.y,l.y,-a.z,l.z)];if(this.look.overlay){let f=this.centers.source.distanceTo(this.centers.moved)*(1-this.look.pose),d=2*f+(f>0?this.radius:0);[c,u]=[c+d,u+d]}let h=Math.max(c/r,u/o);this.camera.left=-e*h/2,this.camera.right=e*h/2,this.camera.top=t*h/2,this.camera.bottom=-t*h/2,this.camera.updateProjectionMatrix(),this.controls.handleResize(),this.redraw()}redraw(){this.isDirty=!0}arrange(){this.camera.updateMatrixWorld();let e=new X().setFromMatrixColumn(this.camera.matrixWorld,0),t=new X().setFromMatrixColumn(this.camera.matrixWorld,1),{source:i,target:s}=this.groups;if(i.position.set(0,0,0),s.position.set(0,0,0),!this.look.overlay){let o=this.isStacked(),a=(o?this.camera.top-this.camera.bottom:this.camera.right-this.camera.left)/this.camera.zoom/4,l=o?t.negate():e;i.position.addScaledVector(l,-a),s.position.addScaledVector(l,a);let c=this.centers.source.clone().applyMatrix4(this.pose);i.position.sub(c).add(this.centers.moved)}let r=new zt().copy(ex);if(this.look.section!==null){let o=new X().setFromMatrixColumn(this.camera.matrixWorld,2),a=this.pair.frame.center.dot(o)+this.radius*(1-2*this.look.section);r.set(o.x,o.y,o.z,a)}for(let o of["source","target"])this.meshes[o].material.uniforms.section.value.copy(r);if(this.lines.visible=this.look.lines,this.look.lines){let o=this.lines.geometry.getAttribute("position"),[a,l]=[this.pair.source.getAttribute("position"),new X];this.lineRows.forEach((c,u)=>{l.fromBufferAttribute(a,c).applyMatrix4(this.pose).add(i.position),o.setXYZ(2*u,l.x,l.y,l.z),l.fromArray(this.pair.images,3*c).add(s.position),o.setXYZ(2*u+1,l.x,l.y,l.z)}),o.needsUpdate=!0}this.scene.updateMatrixWorld()}draw(){this.isDirty=!1;let{renderer:e,canvas:t}=this,{clientWidth:i,clientHeight:s}=t;if(i===0||s===0)return;this.arrange();let r=getComputedStyle(t);if(e.setClearColor(new at(r.getPropertyValue("--canvas").trim()||"#f4f6f8")),this.lines.material.color.set(r.getPropertyValue("--line").trim()||"#333333"),e.setScissorTest(!1),e.clear(),this.look.overlay){e.render(this.scene,this.camera);return}let{source:o,target:a}=this.groups,l=this.lines.visible,c=this.isStacked();this.lines.visible=!1,e.setScissorTest(!0);for(let[u,h,f]of[[o,a,0],[a,o,1]])u.visible=!0,h.visible=!1,c?e.setScissor(0,f===0?s/2:0,i,s/2):e.setScissor(f*i/2,0,i/2,s),e.render(this.scene,this.camera);e.setScissorTest(!1),o.visible=a.visible=!0,l&&(o.visible=a.visible=!1,this.lines.visible=!0,e.render(this.scene,this.camera),o.visible=a.visible=!0)}pick(e,t){this.detail(!0);let{clientWidth:i,clientHeight:s}=this.canvas;this.arrange();let r=new sl;r.setFromCamera(new tt(2*e/i-1,1-2*t/s),this.camera);let o=["source","target"];this.look.overlay||(o=[(this.isStacked()?t>s/2:e>i/2)?"target":"source"]);let a=this.meshes.target.material.uniforms.section.value,l=(x,M)=>M.clone().sub(this.groups[x].position).dot(new X(a.x,a.y,a.z))>a.w,u=o.flatMap(x=>r.intersectObject(this.meshes[x]).map(M=>({side:x,hit:M}))).filter(({side:x,hit:M})=>!l(x,M.point)).sort((x,M)=>x.hit.distance-M.hit.distance)[0];if(u===void 0||!u.hit.face)return null;let{side:h,hit:f}=u,d=this.meshes[h].worldToLocal(f.point.clone()),_=[f.face.a,f.face.b,f.face.c],v=this.meshes[h].geometry.getAttribute("position"),p=x=>d.distanceToSquared(new X().fromBufferAttribute(v,x)),g=_.reduce((x,M)=>p(M)<p(x)?M:x);return this.describe(h,g)}describe(e,t){let{pair:i}=this;if(e==="source")return{side:e,vertex:t,others:[i.nearest[t]],spread_mm:i.columns.spread[t]};let s=[...i.sources.slice(i.starts[t],i.starts[t+1])],r=s.map(o=>i.columns.spread[o]).filter(o=>!Number.isNaN(o));return{side:e,vertex:t,others:s,spread_mm:r.length>0?Math.max(...r):NaN}}mark(e){for(let t of["source","target"])this.marks[t].count=0,this.halos[t].visible=!1;if(e!==null){let{pair:t}=this,i=(a,l)=>new X().fromBufferAttribute(t[a].getAttribute("position"),l).applyMatrix4(a==="source"?this.pose:new gt),s=(a,l)=>{l.slice(0,Zd).forEach((c,u)=>this.marks[a].setMatrixAt(u,new gt().makeTranslation(c.x,c.y,c.z))),this.marks[a].count=Math.min(Zd,l.length),this.marks[a].instanceMatrix.needsUpdate=!0};s(e.side,[i(e.side,e.vertex)]);let r=e.side==="source"?"target":"source",o;if(e.side==="source"?o=e.others[0]<0?[]:[new X().fromArray(t.images,3*e.vertex)]:o=e.others.map(a=>i("source",a)),s(r,o),o.length>0&&e.spread_mm>0){let a=o.reduce((l,c)=>l.add(c),new X).divideScalar(o.length);this.halos[r].position.copy(a),this.halos[r].scale.setScalar(e.spread_mm),this.halos[r].visible=!0}}this.redraw()}project(e,t){this.arrange();let{geometry:i,matrixWorld:s}=this.meshes[e],r=new X().fromBufferAttribute(i.getAttribute("position"),t).applyMatrix4(s),o=new X().fromBufferAttribute(i.getAttribute("normal"),t).transformDirection(s),a=new X().setFromMatrixColumn(this.camera.matrixWorld,2);r.project(this.camera);let{clientWidth:l,clientHeight:c}=this.canvas;return{x:(r.x+1)/2*l,y:(1-r.y)/2*c,facing:o.dot(a)}}frameTimes(e,t){this.detail(t);let i=this.renderer.getContext(),s=new Uint8Array(4);return Array.from({length:e},()=>{let r=performance.now();return this.turn(.05,.01),this.draw(),i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,s),performance.now()-r})}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var nx=[{name:"correspondence",label:"Correspondence",help:"The target is colored along its length, with a grid; each source vertex has the color and the grid of its corresponding point. Where colors jump or the grid breaks, the match is wrong.",unit:""},{name:"confidence",label:"Confidence",help:"Probability that the corresponding point is right to within one edge of the target.",unit:""},{name:"residual",label:"Residual",help:"Distance of each vertex, moved rigidly, from its corresponding point: how far the rest of the match has to bend the source.",unit:"mm"},{name:"displacement",label:"Displacement",help:"The part of it along the outward normal: the target lies inside of the source where it is negative (dark), outside where it is positive (light).",unit:"mm"},{name:"spread",label:"Spread",help:"Expected error of the corresponding point.",unit:"mm"},{name:"outlier",label:"Outliers",help:"Vertices that do not follow the transform or their neighbors, and why.",unit:""}];function pA({map:n,low:e,high:t,label:i}){let s=Jn(null);return Ft(()=>{s.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(vl(n)),Ji,1),0,0)},[n]),A("div",{class:"scale",children:[A("span",{children:e}),A("canvas",{ref:s,width:Ji,height:1,role:"img","aria-label":i}),A("span",{children:t})]})}function ix({job:n,pair:e}){let t=Jn(null),i=Jn(null),[s,r]=Oe(null),[o,a]=Oe(null),[l,c]=Oe({coloring:"correspondence",map:"viridis",top:1,grid:!0,overlay:!1,pose:1,lines:!1,section:null,opacity:.6}),u=yi(()=>{let x=M=>Q_(e.columns[M].map(Math.abs),.95)||1;return{correspondence:1,confidence:1,outlier:1,residual:x("residual"),displacement:x("displacement"),spread:x("spread")}},[e]),h=x=>c(M=>{let b={...M,...x};return{...b,top:u[b.coloring]}});Ft(()=>{let x;try{x=new uh(t.current,e,l)}catch{r("This browser cannot draw in 3D (WebGL 2 is not available). The surfaces can be saved below and opened in another program.");return}return i.current=x,t.current.scene=x,()=>{x.dispose(),i.current=null}},[e]),Ft(()=>i.current?.set(l),[l,e]);let f=Ma();Ft(()=>i.current?.redraw(),[f]);let d=x=>{if(x.buttons!==0)return;let M=t.current.getBoundingClientRect(),b=i.current?.pick(x.clientX-M.left,x.clientY-M.top)??null;i.current?.mark(b),a(b)},_=()=>{i.current?.mark(null),a(null)},v=x=>{let b={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[x.key];if(b)i.current?.turn(...b);else if(x.key==="+"||x.key==="=")i.current?.zoom(1.2);else if(x.key==="-")i.current?.zoom(1/1.2);else if(x.key==="Home")i.current?.view();else return;x.preventDefault()},p=nx.find(({name:x})=>x===l.coloring),g=e.columns;return A("section",{class:"viewer","aria-label":"The match in 3D",children:[A("div",{class:"tools",children:[A("label",{children:["Color"," ",A("select",{value:l.coloring,onChange:x=>h({coloring:x.currentTarget.value}),children:nx.map(({name:x,label:M})=>A("option",{value:x,children:M}))})]}),A("label",{children:["Map"," ",A("select",{value:l.map,onChange:x=>h({map:x.currentTarget.value}),children:[A("option",{value:"viridis",children:"viridis"}),A("option",{value:"cividis",children:"cividis"})]})]}),A("div",{class:"choice",role:"group","aria-label":"Arrangement",children:[A("button",{"aria-pressed":!l.overlay,onClick:()=>h({overlay:!1}),children:"Side by side"}),A("button",{"aria-pressed":l.overlay,onClick:()=>h({overlay:!0}),children:"Overlaid"})]}),A("label",{class:"slider",children:["Pose: original"," ",A("input",{type:"range",min:0,max:1,step:.01,value:l.pose,"aria-label":"Pose, from original to aligned",onInput:x=>h({pose:Number(x.currentTarget.value)})})," aligned"]}),l.overlay&&A("label",{class:"slider",children:["Source"," ",A("input",{type:"range",min:.15,max:1,step:.05,value:l.opacity,"aria-label":"Opacity of the source",onInput:x=>h({opacity:Number(x.currentTarget.value)})})]}),l.coloring==="correspondence"&&A(Rr,{label:"Grid",checked:l.grid,onChange:x=>h({grid:x.currentTarget.checked})}),A(Rr,{label:"Inlier lines",checked:l.lines,onChange:x=>h({lines:x.currentTarget.checked})}),A(Rr,{label:"Section",checked:l.section!==null,onChange:x=>h({section:x.currentTarget.checked?.4:null})}),l.section!==null&&A("input",{type:"range",min:.02,max:.98,step:.01,value:l.section,"aria-label":"Depth of the section",onInput:x=>h({section:Number(x.currentTarget.value)})}),A("span",{class:"group",children:[A("button",{onClick:()=>i.current?.view(),children:"Reset view"}),A("button",{onClick:async()=>{let x=await i.current?.picture();x&&Oh(x,`match-${n.id}.png`)},children:"Save picture"})]})]}),s!==null&&A("p",{class:"failure",children:s}),A("div",{class:"stage",children:[!l.overlay&&A(_n,{children:[A("span",{class:"caption first",children:["Source",l.pose===1?", aligned":l.pose===0?", original pose":""]}),A("span",{class:"caption second",children:"Target"})]}),A("canvas",{ref:t,id:"view",tabIndex:0,role:"img","aria-label":"Source and target surface. Arrow keys turn, plus and minus zoom, Home resets the view.",onPointerMove:d,onPointerLeave:_,onKeyDown:v}),A("output",{class:"readout","aria-live":"off",children:o===null?A("span",{class:"hint",children:"Point at a vertex to see its correspondent. Drag to turn, scroll to zoom, right button to move."}):o.side==="source"?A(_n,{children:[A("b",{children:["source vertex ",o.vertex]})," → ",o.others[0]<0?"no counterpart":`target vertex ${o.others[0]}`," · confidence ",$e(g.confidence[o.vertex],2)," · spread"," ",ci(g.spread[o.vertex])," · residual ",ci(g.residual[o.vertex])," · ",Us[Math.floor(g.outlier[o.vertex]*Us.length)]?.name]}):A(_n,{children:[A("b",{children:["target vertex ",o.vertex]})," ← ",o.others.length===0?"no source vertex has it as its nearest":`${o.others.length} source ${o.others.length===1?"vertex":"vertices"}: ${o.others.slice(0,6).join(", ")}${o.others.length>6?" …":""}`,o.spread_mm>0&&` · spread ${ci(o.spread_mm)}`]})})]}),A("div",{class:"legend",children:[l.coloring==="outlier"?A("ul",{class:"categories",children:Us.map(({name:x,color:M},b)=>{let y=g.outlier.reduce((S,m)=>S+(Math.floor(m*Us.length)===b?1:0),0);return A("li",{children:[A("svg",{width:"12",height:"12","aria-hidden":"true",children:A("rect",{width:"12",height:"12",fill:Z_(M)})})," ",x,": ",y.toLocaleString("en")]})})}):A(pA,{map:l.map,low:l.coloring==="correspondence"?"one end of the target":l.coloring==="displacement"?`≤ −${$e(l.top,2)} mm`:`0 ${p.unit}`,high:l.coloring==="correspondence"?"the other end":`${l.coloring==="confidence"?"":"≥ "}${$e(l.top,2)} ${p.unit}`,label:`Scale of ${Pn(l.coloring)}`}),A("p",{children:[p.help," Gray: no counterpart."]})]})]})}var mA=[["Correspondences, CSV","correspondences?format=csv","correspondences.csv"],["Aligned source, PLY","aligned?format=ply","aligned.ply"],["Bent source, PLY","warped?format=ply","warped.ply"],["Bent source, GIFTI","warped?format=gifti","warped.surf.gii"],["Bent source, VTP","warped?format=vtp","warped.vtp"],["Target surface, PLY","surfaces/target?format=ply","target.ply"],["Both surfaces in color, glTF","correspondences?format=glb","match.glb"],["Transform, ITK","transform?format=tfm","transform.tfm"],["Transform, FreeSurfer","transform?format=lta","transform.lta"],["Result, JSON","result","result.json"],["Report, HTML","report?format=html","report.html"]];function sx({job:n,failed:e}){return A("div",{class:"saves",children:mA.map(([t,i,s])=>A("button",{onClick:()=>Wp(`v1/jobs/${n.id}/${i}`,s).catch(e),children:t}))})}function ox({id:n}){let[e,t]=Oe(null),[i,s]=Oe([]),[r,o]=Oe(null),[a,l]=Oe(null),[c,u]=Oe(!0),[h,f]=Oe(null),d=y=>f(Rn(y)),_=Js();Ei(y=>{t(null),s([]),o(null),l(null),f(null),br(()=>Ut(`v1/jobs/${n}`,y),y).then(I=>!y.aborted&&t(P=>P??I),I=>!y.aborted&&d(I));let S=[],m=0,w=()=>{m=0;let I=S;S=[],y.aborted||s(P=>[...P,...I])};fm(n,{job:I=>t(P=>yr(P,{...I,queue_position:I.queue_position??(I.state==="queued"?P?.queue_position:void 0)})),trace:I=>{S.push(...I),m===0&&(m=window.setTimeout(w,60))},progress:I=>t(P=>P===null?P:{...P,progress:I}),connected:u,failed:d},y)},[n]);let v=e?.state==="succeeded";Ei(y=>{!v||e===null||j_(e,y).then(S=>{y.aborted||(l(S.result),o(S.pair))},S=>!y.aborted&&d(S))},[n,v]);let p=e!==null&&!Zn(e.state),g=yi(()=>A(xA,{points:i,isLive:p}),[i,p]);if(e===null)return h===null?A("p",{class:"loading",children:"Loading the job …"}):A(Ln,{text:h});let x=Xp(e),M=y=>{f(null),is("POST",`v1/jobs/${n}/${y}`).then(S=>y==="retry"?Zs(`jobs/${S.id}`):t(m=>m?.id===S.id?yr(m,S):m),d)},b=e.started_at?Si((e.finished_at?Date.parse(e.finished_at):_)-Date.parse(e.started_at)):null;return A("article",{class:"job",children:[A("h1",{class:"sub",children:["Job ",A("code",{children:n})]}),A("section",{class:`verdict ${x.tone}`,"aria-label":"Verdict",children:[A("span",{class:"mark","aria-hidden":"true",children:x.mark}),A("div",{children:[A("p",{class:"title",id:"verdict",children:x.title}),x.lines.map(y=>A("p",{children:y})),A("p",{class:"next",children:[A("b",{children:"Next:"})," ",x.next]})]}),A("div",{class:"actions",children:[!Zn(e.state)&&A("button",{disabled:e.cancel_requested,onClick:()=>M("cancel"),children:"Cancel"}),Zn(e.state)&&A("button",{onClick:()=>M("retry"),children:"Retry"})]})]}),A(Ln,{text:h}),!Zn(e.state)&&A("p",{class:"live",role:"status",children:[A(Cr,{share:e.progress?.fraction??0,label:"Progress"})," ",no(e.progress?.fraction??0)," · ",e.progress?.message??Pn(e.state)," ",b!==null&&`· ${b}`,!c&&A(ki,{tone:"bad",children:"connection lost, trying again"})]}),r!==null&&A(ix,{job:e,pair:r}),v&&r===null&&h===null&&A("p",{class:"loading big",children:"Loading the surfaces …"}),A("div",{class:"columns",children:[a!==null&&A(gA,{result:a}),g,A("section",{class:"card",children:[A("h2",{children:"The job"}),A(ei,{rows:[["State",A(_o,{state:e.state})],["Method",`${e.method} ${e.method_version}`],["Source",`${$e(e.source.n_vertices)} vertices, ${e.source.report.format}`],["Target",`${$e(e.target.n_vertices)} vertices, ${e.target.report.format}`],["Priority",$e(e.priority)],["Attempt",`${e.attempt} of ${e.max_attempts}`],["Created",new Date(e.created_at).toLocaleString()],["Ran for",b??"–"],["Result from",e.cached?"an earlier, equal job":"this job"],...e.batch_id?[["Batch",A("a",{href:`#/batches/${e.batch_id}`,children:e.batch_id.slice(-8)})]]:[],...e.retry_of?[["Retry of",A("a",{href:`#/jobs/${e.retry_of}`,children:e.retry_of.slice(-8)})]]:[],...e.external_ref?[["Reference",e.external_ref]]:[],...Object.entries(e.labels).map(([y,S])=>[`Label ${y}`,S])]})]}),a!==null&&A(vA,{result:a}),v&&A("section",{class:"card",children:[A("h2",{children:"Save"}),A(sx,{job:e,failed:d})]}),A(yA,{job:e}),A("section",{class:"card",children:[A("h2",{children:"Parameters and provenance"}),A(bA,{job:e}),a!==null&&A(ei,{rows:[["Program",`${a.provenance.version}, commit ${a.provenance.commit}`],["Seed",$e(a.provenance.seed)],["Source file",A("code",{class:"hash",children:e.source.hash})],["Target file",A("code",{class:"hash",children:e.target.hash})]]})]})]})]})}function gA({result:n}){let{surface_distance:e,topology:t,deformation:i,support:s,reliability:r}=n,o=[["Surface distance, mean",ci(e.mean_mm)],["Surface distance, 95 % within",ci(e.p95_mm)],["Surface distance, largest",ci(e.max_mm)],["Neighbors that stay neighbors",no(t.consistency)],["Target vertices reached",no(t.coverage)],["Inliers of the transform",`${$e(s.inliers)} (${no(s.ratio)})`],["Rotation",`${n.transform.rotation_angle_deg.toFixed(1)}°`]];return i&&o.push(["Folded triangles",`${$e(i.folded_triangles)} (${no(i.folded_area_share)} of the area)`],["Area, target over source (5th to 95th percentile)",`${$e(i.area_ratio)} (${$e(i.area_ratio_p05)} to ${$e(i.area_ratio_p95)})`],["Volume, target over source",$e(i.volume_ratio)]),r&&(o.push(["Misfit (about 1.0 for copies, 1.2 for two subjects)",$e(r.misfit)],["Misfit of the next best pose",$e(r.runner_up_misfit)],["Misfit of a mirrored source",$e(r.other_handedness_misfit)],["Curvature agreement",$e(r.curvature_agreement)],["Agreement of directions",$e(r.normal_agreement)]),r.distortion!==void 0&&o.push(["Distortion (0 if angles are kept, about 0.2 for two subjects)",$e(r.distortion)])),A("section",{class:"card",children:[A("h2",{children:"How good it is"}),A(ei,{rows:o})]})}var rx=4e3;function _A(n){if(n.length<=rx)return n;let e=Math.ceil(2*n.length/rx),t=[];for(let i=0;i<n.length;i+=e){let s=Math.min(n.length,i+e),[r,o]=[i,i];for(let a=i+1;a<s;a++){let l=n[a].energy;l!==void 0&&(l>=(n[r].energy??1/0)||(r=a),l<=(n[o].energy??-1/0)||(o=a))}for(let a=i;a<s;a++){let l=n[a];(a===r||a===o||a===n.length-1||l.support!==void 0||l.round!==n[a-1]?.round)&&t.push(l)}}return t}function xA({points:n,isLive:e}){let[t,i]=Oe(!1),[s,r]=Oe(!1),[o,a]=Oe("all"),[l,c]=Oe(null),u=yi(()=>n.filter(ha),[n]),h=yi(()=>n.filter(S=>!ha(S)&&(S.energy!==void 0||S.support!==void 0)),[n]),f=(l??(u.length>0?"field":"labels"))==="field"?u:h,d=yi(()=>[...new Set(f.map(S=>S.round))],[f]),_=d.map(String).includes(o),v=yi(()=>f.filter(S=>!_||String(S.round)===o),[f,_,o]),p=yi(()=>_A(v),[v]),g=S=>p.map(m=>{let w=m[S];return w===void 0||t&&S!=="support"&&w<=0?null:w}),x=S=>p.some(m=>m[S]!==void 0),M=p.flatMap((S,m)=>m===0||p[m-1].round!==S.round?[{at:S.seq,text:`round ${S.round}`}]:[]),b=v.at(-1),y=[{label:"energy",color:"#0072b2",values:g("energy"),width:2.5},...s?[{label:f===u?"misfit":"unary",color:"#d55e00",values:g("energy_unary"),dash:[6,3]},{label:f===u?"deformation":"pairwise",color:"#009e73",values:g("energy_pairwise"),dash:[2,3]}]:[],...x("lower_bound")?[{label:"lower bound",color:"#8c6d1f",values:g("lower_bound"),dash:[10,4]}]:[],...x("temperature")?[{label:"temperature",color:"#cc79a7",values:g("temperature"),scale:"right"}]:[],...x("support")&&!x("temperature")?[{label:"support (inliers)",color:"#b0607f",values:g("support"),scale:"right",points:!0}]:[]];return A("section",{class:"card wide",id:"trace","data-points":n.length,"data-last":n.at(-1)?.seq??0,children:[A("h2",{children:["Energy ",e&&A(ki,{tone:"wait",children:"live"})]}),A("div",{class:"tools",children:[A(Rr,{label:"Logarithmic",checked:t,onChange:S=>i(S.currentTarget.checked)}),A(Rr,{label:"Its parts",checked:s,onChange:S=>r(S.currentTarget.checked)}),u.length>0&&h.length>0&&A("label",{children:["Of"," ",A("select",{value:f===u?"field":"labels",onChange:S=>c(S.currentTarget.value==="field"?"field":"labels"),children:[A("option",{value:"field",children:"the displacement field"}),A("option",{value:"labels",children:"the labels"})]})]}),d.length>1&&A("label",{children:["Round"," ",A("select",{value:_?o:"all",onChange:S=>a(S.currentTarget.value),children:[A("option",{value:"all",children:"all"}),d.map(S=>A("option",{value:String(S),children:S}))]})]}),b&&A("span",{children:[n.length," points · latest ",$e(b.energy??null)," in ",Pn(b.phase),", round ",b.round,", iteration ",b.iteration]})]}),p.length===0?A("p",{class:"hint",children:e?"The first point comes with the first iteration.":"This method minimizes no energy, or its trace has been removed."}):A(xo,{title:`Energy over ${n.length} points, the last one ${$e(b?.energy??null)}`,x:p.map(S=>S.seq),series:y,log:t,height:260,xLabel:"point of the trace",yLabel:"energy, lower is better",rightLabel:x("temperature")?"temperature":"inliers",marks:M})]})}function vA({result:n}){let{total:e=1,...t}=n.timings_ms,i=Object.entries(t).sort(([,s],[,r])=>r-s);return A("section",{class:"card",children:[A("h2",{children:["Time: ",Si(e)]}),A(ei,{rows:i.map(([s,r])=>[Pn(s),A(_n,{children:[A(Cr,{share:r/e,label:`Share of ${Pn(s)}`})," ",Si(r)]})])})]})}function yA({job:n}){let{source:e,target:t}=n,i=(s,r)=>A("tr",{children:[A("th",{scope:"row",children:s}),A("td",{children:r(e)}),A("td",{children:r(t)})]});return A("section",{class:"card",children:[A("h2",{children:"Surfaces"}),A("table",{class:"plain",children:[A("thead",{children:A("tr",{children:[A("td",{}),A("th",{scope:"col",children:"Source"}),A("th",{scope:"col",children:"Target"})]})}),A("tbody",{children:[i("Format",s=>s.report.format),i("Vertices",s=>$e(s.n_vertices)),i("Faces",s=>$e(s.n_faces)),i("Genus",s=>String(s.report.topology.genus??"open")),i("Pieces",s=>$e(s.report.topology.n_components)),i("Boundary edges",s=>$e(s.report.topology.n_boundary_edges)),i("Area",s=>`${$e(s.report.topology.area_mm2)} mm²`),i("Volume",s=>s.report.topology.volume_mm3===null?"–":`${$e(s.report.topology.volume_mm3)} mm³`),i("Repairs",s=>s.report.repairs.length===0?"none":String(s.report.repairs.length))]})]})]})}function bA({job:n}){let[e,t]=Oe(null);Ei(o=>{br(()=>Ut(`v1/methods/${n.method}`,o),o).then(a=>!o.aborted&&t(a.defaults),()=>{})},[n.method]);let i=jd(n.parameters),s=new Map(e?jd(e):[]),r=e===null?[]:i.filter(([o,a])=>o!=="seed"&&s.get(o)!==a);return A(_n,{children:[A("p",{children:e===null?"":r.length===0?`All as the method ${n.method} sets them.`:`Different from the method ${n.method}:`}),r.length>0&&A(ei,{rows:r.map(([o,a])=>[o,A("code",{children:a})])}),A("details",{children:[A("summary",{children:["All ",i.length," parameters"]}),A(ei,{rows:i.map(([o,a])=>[o,A("code",{children:a})])})]})]})}function jd(n,e=""){return n===null||typeof n!="object"||Array.isArray(n)?[[e,JSON.stringify(n)]]:Object.entries(n).flatMap(([t,i])=>jd(i,e===""?t:`${e}.${t}`))}function SA(n){let e=new Map;for(let t of n.split(`
`)){let i=/^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)$/.exec(t);if(!i||t.startsWith("#"))continue;let s=Object.fromEntries([...(i[2]??"").matchAll(/(\w+)="((?:[^"\\]|\\.)*)"/g)].map(([,o,a])=>[o,a])),r=e.get(i[1])??[];r.push({labels:s,value:Number(i[3])}),e.set(i[1],r)}return e}var ax=500;function lx(){let[n,e]=Oe(null),[t,i]=Oe([]),[s,r]=Oe([]),[o,a]=Oe([]),[l,c]=Oe(null),[u,h]=Oe(null),f=Js();if(Ei(m=>{(async()=>{for(let w=0;!m.aborted;w++){try{let I=SA(await(await bi("metrics",{signal:m})).text()),P=L=>I.get("homolog_jobs")?.find(({labels:N})=>N.state===L)?.value??0;e(I),i(L=>[...L.slice(-299),{at:Date.now(),queued:P("queued"),running:P("running")}]),r((await Ut("v1/jobs?state=running&page_size=100",m)).jobs),Ut("readyz",m).then(({dependencies:L})=>c(L),L=>c(L instanceof Oi?L.problem.dependencies??{}:null)),w%10===0&&a(await MA(m)),h(null)}catch(I){m.aborted||h(Rn(I))}await wi(2e3,m)}})()},[]),n===null)return u===null?A("p",{class:"loading",children:"Loading …"}):A(Ln,{text:u});let d=m=>n.get(m)?.[0]?.value??0,_=(m,w)=>(n.get(m)??[]).map(({labels:I,value:P})=>[I[w]??Object.values(I).join(" "),P]).filter(([,I])=>I>0),v=t.at(-1),p=d("homolog_queue_oldest_age_seconds"),g=d("homolog_job_store_up")===1,x=Object.entries(l??{}).filter(([,m])=>m!=="ok"),M=v.queued>0&&v.running===0&&p>30,b=!g||x.length>0||M?"bad":p>600?"wait":"good",y=new Map;for(let m of s){let w=m.worker??"unnamed worker";y.set(w,[...y.get(w)??[],m])}let S=t[0].at;return A("div",{children:[A("h1",{children:"Operations"}),A("section",{class:`verdict ${b}`,"aria-label":"Verdict",children:[A("span",{class:"mark","aria-hidden":"true",children:b==="good"?"✓":b==="bad"?"✕":"…"}),A("div",{children:[A("p",{class:"title",children:b==="good"?"The queue is well":M?"Nothing runs":b==="wait"?"Jobs wait long":"A dependency fails"}),A("p",{children:[$e(v.queued)," queued, ",$e(v.running)," running; the oldest has waited ",Si(p*1e3),"."]}),A("p",{class:"next",children:[A("b",{children:"Next:"})," ",b==="good"?"nothing to do.":M?"Look whether workers run, and whether a job asks for more memory than there is.":b==="wait"?"Add workers, or lower the priority of what can wait.":`Look at ${x.map(([m,w])=>`${m} (${w})`).join(", ")||"the database"}.`]})]})]}),A(Ln,{text:u}),A("div",{class:"columns",children:[A("section",{class:"card wide",children:[A("h2",{children:"Queue, since this page was opened"}),A(xo,{title:`Queued ${v.queued}, running ${v.running}`,x:t.map(({at:m})=>(m-S)/1e3),series:[{label:"queued",color:"#2f7ebc",values:t.map(({queued:m})=>m),width:2},{label:"running",color:"#d55e00",values:t.map(({running:m})=>m),width:2}],height:220,xLabel:"seconds",yLabel:"jobs"})]}),A("section",{class:"card",children:[A("h2",{children:"Workers and what they run"}),y.size===0&&A("p",{class:"hint",children:"No job is running."}),[...y].map(([m,w])=>A("div",{children:[A("h3",{children:[A("code",{children:m}),": ",w.length," ",w.length===1?"job":"jobs"]}),A("ul",{class:"running",children:w.map(I=>A("li",{children:[A("a",{href:`#/jobs/${I.id}`,children:["…",Mi(I.id)]})," ",I.method,", ",Pn(I.progress?.phase??"starting"),", ",I.started_at?io(I.started_at,f):""," ",A(Cr,{share:I.progress?.fraction??0,label:`Progress of ${Mi(I.id)}`})]}))})]},m))]}),A("section",{class:"card",children:[A("h2",{children:"Failures by kind"}),o.length===0?A("p",{class:"hint",children:"No job of this tenant has failed."}):A(ei,{rows:o.map(([m,w,I])=>[m,A(_n,{children:[$e(w),", newest ",A("a",{href:`#/jobs/${I}`,children:["…",Mi(I)]})]})])}),A("p",{class:"soft",children:["Among the last ",ax," jobs of this tenant that failed or were given up."]})]}),A("section",{class:"card",children:[A("h2",{children:"Finished since the service was started"}),A(ei,{rows:_("homolog_jobs_finished_total","state").map(([m,w])=>[m,$e(w)])}),A(ei,{rows:_("homolog_problems_total","type").map(([m,w])=>[`Refused: ${Pn(m).replaceAll("-"," ")}`,$e(w)])})]}),A("section",{class:"card",children:[A("h2",{children:"This process"}),A(ei,{rows:[...Object.entries(l??{}).map(([m,w])=>[Pn(m),A(ki,{tone:w==="ok"?"good":"bad",children:w})]),["Memory",Ol(d("process_resident_memory_bytes"))],["Running since",d("process_start_time_seconds")?new Date(1e3*d("process_start_time_seconds")).toLocaleString():"–"],["Leases of lost workers",$e(d("homolog_leases_expired_total"))],["Jobs given up",$e(d("homolog_jobs_dead_total"))]]})]})]})]})}async function MA(n){let e=await Promise.all(["failed","dead"].map(i=>Ut(`v1/jobs${qs({state:i,page_size:ax})}`,n))),t=new Map;for(let i of e.flatMap(({jobs:s})=>s)){let s=i.error?.title??"Crashed too often",[r,o]=t.get(s)??[0,i.id];t.set(s,[r+1,o>i.id?o:i.id])}return[...t].map(([i,[s,r]])=>[i,s,r]).sort(([,i],[,s])=>s-i)}function cx({ply:n,fault:e,name:t}){let i=Jn(null),s=Ma(),[r,o]=Oe(null);return Ft(()=>{let a=i.current,l;try{l=new Ko({canvas:a,antialias:!0})}catch{o("This browser cannot draw in 3D.");return}let{geometry:c}=ih(n),u=Hd(c),h=c.boundingSphere?.radius||1,f=new Nr,d=new On(c,new Ka({color:9417945,side:ii}));f.add(d,new tl(16777215,8952234,1.4));let _=new il(16777215,1.6);if(f.add(_),e){let P=(L,N)=>{let B=new On(new sr(h*L,24,16),new Is({color:14024812,transparent:!0,opacity:N,depthTest:!1}));B.position.set(...e),B.renderOrder=1,f.add(B)};P(.03,1),P(.1,.35)}l.setPixelRatio(Math.min(2,devicePixelRatio));let v=new Ds(-1,1,1,-1,-20*h,40*h),[p,g,x]=u.axes;v.up.copy(g);let M=e&&new X(...e).sub(u.center).dot(x)<0?-4:4;v.position.copy(u.center).addScaledVector(x,M*h).addScaledVector(p,1e-4),v.lookAt(u.center);let b=new Qo(v,a);b.target.copy(u.center),b.staticMoving=!0,b.rotateSpeed=3;let y=!0;b.addEventListener("change",()=>y=!0);let S=()=>{let{clientWidth:P,clientHeight:L}=a;if(P===0)return;l.setSize(P,L,!1);let N=Math.max(1.1*(u.high.x-u.low.x)/P,1.2*(u.high.y-u.low.y)/L)/2||h/L;[v.left,v.right,v.top,v.bottom]=[-N*P,N*P,N*L,-N*L],v.updateProjectionMatrix(),b.handleResize(),y=!0},m=new ResizeObserver(S);m.observe(a);let w=0,I=()=>{w=requestAnimationFrame(I),b.update(),y&&(y=!1,_.position.copy(v.position).sub(u.center),l.setClearColor(new at(getComputedStyle(a).getPropertyValue("--canvas").trim()||"#f4f6f8")),l.render(f,v))};return S(),I(),()=>{cancelAnimationFrame(w),m.disconnect(),b.dispose(),c.dispose(),l.dispose()}},[n,e?.join(),s]),r===null?A("canvas",{class:"preview",ref:i,role:"img","aria-label":`The ${t} surface${e?", the place of the fault is marked":""}`}):A("p",{class:"failure",children:r})}var ux=["source","target"],wA=128<<20;function hx(){let[n,e]=Oe({source:null,target:null}),[t,i]=Oe([]),[s,r]=Oe({}),[o,a]=Oe("balanced"),[l,c]=Oe({}),[u,h]=Oe(0),[f,d]=Oe(""),[_,v]=Oe(""),[p,g]=Oe([]),[x,M]=Oe(null),[b,y]=Oe(null),[S,m]=Oe(!1);Ft(()=>{Ut("v1/methods").then(({methods:k})=>i(k),k=>M(Rn(k))),Ut("openapi.json").then(({components:k})=>r(k.schemas),k=>M(Rn(k)))},[]);let w=(k,se)=>e(Y=>({...Y,[k]:{...Y[k]??{name:"",mesh:null,ply:null,failure:null},...se}})),I=async(k,se,Y)=>{y(null),w(k,{name:Y,mesh:null,ply:null,failure:null});try{let q=await(await bi(`v1/meshes?file_name=${encodeURIComponent(TA(Y))}`,{method:"POST",body:se,headers:{"content-type":"application/octet-stream"}})).json();if(w(k,{mesh:q}),q.n_bytes>wA)return;let ie=await bi(`v1/meshes/${q.id}/surface`).catch(()=>null);ie&&w(k,{ply:await ie.arrayBuffer()})}catch(K){w(k,{failure:Rn(K)})}},P=(k,se)=>{if(se.length<2)return se.forEach(ie=>{I(k,ie,ie.name)});let[Y,K]=[...se].sort((ie,ne)=>ie.name.localeCompare(ne.name)),q=/target|fixed|reference/i.test(Y.name)||/source|moving/i.test(K.name);I("source",q?K:Y,(q?K:Y).name),I("target",q?Y:K,(q?Y:K).name)},L=()=>ux.forEach(k=>{let se=`${k}.nii.gz`;fetch(Nh(`phantoms/${se}`)).then(async Y=>{I(k,await Y.blob(),se)},Y=>w(k,{failure:Rn(Y)}))}),{source:N,target:B}=n,D=!!(N?.mesh&&B?.mesh),G=async k=>{m(!0),M(null),g([]),y(null);try{let se=_.split(/[\s,]+/).filter(Boolean).map(q=>[q.slice(0,q.indexOf(":")),q.slice(q.indexOf(":")+1)]),Y={source:{mesh_id:N.mesh.id},target:{mesh_id:B.mesh.id},parameters:PA({method:o,...l}),priority:u,labels:Object.fromEntries(se),...f===""?{}:{external_ref:f}},K=await is("POST",`v1/jobs${k?"?validate_only=true":""}`,Y);k?M(""):Zs(`jobs/${K.id}`)}catch(se){if(M(Rn(se)),se instanceof Oi){let{errors:Y,input:K,detail:q,title:ie,place_mm:ne}=se.problem;g(Y??[]),(K==="source"||K==="target")&&y({side:K,text:q??ie,place:ne??null})}}finally{m(!1)}},J=t.find(({name:k})=>k===o);return A("div",{class:"submit",children:[A("h1",{children:"Submit a pair"}),A("p",{class:"tools",children:[A("span",{children:"The source is moved and bent onto the target, which stays."}),A("button",{onClick:L,children:"Take the two built-in phantoms"})]}),A("div",{class:"pair",children:ux.map(k=>A(AA,{side:k,given:n[k],refusal:b?.side===k?b:null,take:se=>P(k,se)},k))}),A("section",{class:"card",children:[A("h2",{children:"Method"}),A("div",{class:"tools",children:[A("label",{children:["Method"," ",A("select",{value:o,onChange:k=>{a(k.currentTarget.value),c({})},children:t.map(({name:k})=>A("option",{value:k,children:k}))})]}),A("label",{children:["Priority ",A("input",{type:"number",min:-100,max:100,value:u,onInput:k=>h(Number(k.currentTarget.value))})]}),A("label",{children:["Reference ",A("input",{value:f,onInput:k=>d(k.currentTarget.value)})]}),A("label",{children:["Labels ",A("input",{placeholder:"study:baseline",value:_,onInput:k=>v(k.currentTarget.value)})]})]}),A("p",{children:J?.description}),J&&A(EA,{method:J,schemas:s,changed:l,change:c,faults:p})]}),x===""?A("p",{class:"success",role:"status",children:"These files and parameters are accepted."}):A(Ln,{text:x}),A("div",{class:"tools send",children:[A("button",{class:"primary",disabled:!D||S,onClick:()=>{G(!1)},children:"Match them"}),A("button",{disabled:!D||S,onClick:()=>{G(!0)},children:"Only check"}),!D&&A("span",{class:"hint",children:"Both surfaces are needed."})]})]})}var TA=n=>`file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(n)?.[0]??""}`;function AA({side:n,given:e,refusal:t,take:i}){let[s,r]=Oe(!1),o=e?.mesh,a=o?.report?.topology??o?.problem?.topology,l=t?.place??o?.problem?.place_mm??null,c=t?.text??(o?.problem?o.problem.detail??o.problem.title:null);return A("section",{class:`card drop ${s?"over":""}`,"aria-label":n,onDragOver:u=>{u.preventDefault(),r(!0)},onDragLeave:()=>r(!1),onDrop:u=>{u.preventDefault(),r(!1),i([...u.dataTransfer?.files??[]])},children:[A("h2",{children:n==="source"?"Source":"Target"}),A("label",{class:"file",children:[e===null?"Drop a file here, or choose one: ":`${e.name}${o?`, ${Ol(o.n_bytes)}`:""} `,A("input",{type:"file","aria-label":`File of the ${n}`,onChange:u=>i([...u.currentTarget.files??[]])})]}),e===null&&A("p",{class:"hint",children:"Surfaces: GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3. Label volumes: NIfTI, MGZ, NRRD, MetaImage, DICOM SEG."}),e!==null&&o===null&&e.failure===null&&A("p",{class:"loading",children:"Sending and checking …"}),A(Ln,{text:e?.failure??null}),c&&A("p",{class:"failure",role:"alert",children:[A("b",{children:"With default parameters it is refused:"})," ",c,l&&". The place is marked."]}),o&&!c&&A("p",{class:"success",role:"status",children:"✓ It can be matched."}),e?.ply&&A(cx,{ply:e.ply,fault:l,name:n}),a&&A(ei,{rows:[["Format",o?.report?.format??"–"],["Vertices",$e(a.n_vertices)],["Faces",$e(a.n_faces)],["Pieces",$e(a.n_components)],["Genus",a.genus===null?"open":$e(a.genus)],["Boundary edges",$e(a.n_boundary_edges)],["Edges with more than two faces",$e(a.n_nonmanifold_edges)],["Area",`${$e(a.area_mm2)} mm²`],["Volume",a.volume_mm3===null?"–":`${$e(a.volume_mm3)} mm³`],["Repairs",o?.report?.repairs.length?String(o.report.repairs.length):"none"]]})]})}function EA({method:n,schemas:e,changed:t,change:i,faults:s}){let r=u=>{let h=u.$ref?.split("/").at(-1),f=h===void 0?void 0:e[h];if(f)return{...r(f),description:u.description??f.description};let d=[...u.oneOf??[],...u.anyOf??[]].filter(_=>_.type!=="null");return d.length===1?{...r(d[0]),description:u.description??d[0].description,type:[String(r(d[0]).type),"null"]}:u},o=u=>u.reduce((h,f)=>h===null||typeof h!="object"?void 0:h[f],n.defaults),a=(u,h,f)=>{let d={...t,[u]:h};JSON.stringify(h)===JSON.stringify(f)&&delete d[u],i(d)},l=(u,h)=>Object.entries(r(u).properties??{}).map(([f,d])=>{let _=r(d),v=[...h,f];if(v.join()==="method")return null;if(_.properties)return A("fieldset",{children:[A("legend",{children:Pn(f)}),_.description&&A("p",{class:"soft",children:_.description}),l(_,v)]},f);let p=v.join("."),g=o(v),x=p in t?t[p]:g,M=s.find(({pointer:b})=>b.replace(/^\/parameters/,"")===`/${v.join("/")}`);return A(RA,{name:p,schema:_,value:x,isChanged:p in t,fault:M,set:b=>a(p,b,g)},p)}),c=Object.keys(t).length;return A("details",{children:[A("summary",{children:["Parameters",c>0&&`: ${c} changed`]}),c>0&&A("button",{onClick:()=>i({}),children:"All as the method sets them"}),A("div",{class:"fields",children:l({$ref:"PartialParameters"},[])})]})}var CA=[[/_mm$/,"mm"],[/_deg$/,"°"],[/_ms$/,"ms"],[/_s$/,"s"],[/_bytes$/,"bytes"]];function RA({name:n,schema:e,value:t,isChanged:i,fault:s,set:r}){let[o,a]=Oe(null),l=[e.type??[]].flat(),c=CA.find(([v])=>v.test(n))?.[1],u=l.includes("number")||l.includes("integer"),h=e.enum??e.oneOf?.flatMap(v=>v.const??v.enum??[]),f=Pn(n.split(".").at(-1)),d;h&&h.length>0&&!l.includes("array")?d=A("select",{value:t===null?"null":String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value),children:[(l.includes("null")||t===null)&&A("option",{value:"null",children:"not set"}),h.map(v=>A("option",{value:String(v),children:String(v)}))]}):l.includes("boolean")?d=A("select",{value:String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value==="true"),children:[(l.includes("null")||t===null)&&A("option",{value:"null",children:"not set"}),A("option",{value:"true",children:"yes"}),A("option",{value:"false",children:"no"})]}):u?d=A("input",{type:"number",step:l.includes("integer")?e.multipleOf??1:"any",min:e.minimum,max:e.maximum,placeholder:l.includes("null")?"not set":void 0,value:t==null?"":String(t),onChange:v=>r(v.currentTarget.value===""?null:Number(v.currentTarget.value))}):d=A("input",{value:o??JSON.stringify(t??null),spellcheck:!1,onInput:v=>a(v.currentTarget.value),onChange:v=>{try{r(JSON.parse(v.currentTarget.value)),a(null)}catch{}}});let _=[e.minimum!==void 0&&`at least ${$e(e.minimum)}`,e.maximum!==void 0&&`at most ${$e(e.maximum)}`].filter(Boolean).join(", ");return A("div",{class:`field ${i?"changed":""}`,children:[A("label",{children:[A("span",{children:[f," ",c&&A("span",{class:"soft",children:["(",c,")"]})]})," ",d]}),A("p",{class:"soft",children:[e.description," ",_&&`(${_})`]}),s&&A(Ln,{text:s.detail})]})}function PA(n){let e={};for(let[t,i]of Object.entries(n)){let s=t.split("."),r=s.pop(),o=s.reduce((a,l)=>a[l]??={},e);o[r]=i}return e}var fx=[["jobs","Jobs"],["submit","Submit"],["batches","Batches"],["operations","Operations"]],dx="homolog-theme";function IA(){let[n,e]=Oe(localStorage.getItem(dx)??"auto");return Ft(()=>{n==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,localStorage.setItem(dx,n),window.dispatchEvent(new Event("theme"))},[n]),[n,e]}function LA({done:n}){let[e,t]=Oe(""),[i,s]=Oe(null);return A("form",{class:"card key",onSubmit:async o=>{o.preventDefault(),to.set(e.trim());try{await Ut("v1/jobs?page_size=1"),n()}catch(a){to.set(null),s(Rn(a))}},children:[A("h1",{children:"This service asks for a key"}),A("p",{children:["Paste an API key of your tenant. It is kept for this tab only, until you close it. Whoever operates the service creates keys with ",A("code",{children:"homolog keys create"}),"."]}),A("label",{children:["API key ",A("input",{type:"password",autocomplete:"off",spellcheck:!1,value:e,onInput:o=>t(o.currentTarget.value),required:!0})]}),A(Ln,{text:i}),A("button",{class:"primary",type:"submit",children:"Open"})]})}function DA(){let{path:n,query:e}=Vg(),[t,i]=Oe(!1),[s,r]=Oe(""),[o,a]=IA();Ft(()=>Hp(()=>i(!0)),[]),Ft(()=>{Ut("healthz").then(({version:h})=>r(h),()=>{})},[]);let[l="jobs",c]=n;Ft(()=>{let h=fx.find(([f])=>f===l)?.[1]??"Dashboard";document.title=c?`${l==="batches"?"Batch":"Job"} ${c.slice(-8)} · homolog`:`${h} · homolog`},[l,c]);let u;return t?u=A(LA,{done:()=>i(!1)}):l==="jobs"&&c!==void 0?u=A(ox,{id:c},c):l==="jobs"?u=A(Wg,{query:e}):l==="submit"?u=A(hx,{}):l==="batches"&&c!==void 0?u=A($g,{id:c},c):l==="batches"?u=A(Yg,{}):l==="operations"?u=A(lx,{}):u=A("p",{class:"failure",children:"There is no view of this name. Choose one above."}),A(_n,{children:[A("a",{class:"skip",href:"#main",onClick:h=>(h.preventDefault(),document.getElementById("main")?.focus()),children:"Skip to the content"}),A("header",{children:[A("a",{class:"name",href:"#/jobs",children:"homolog"}),A("nav",{"aria-label":"Views",children:fx.map(([h,f])=>A("a",{href:`#/${h}`,"aria-current":h===l?"page":void 0,children:f}))}),A("span",{class:"end",children:[A("label",{children:[A("span",{class:"quiet",children:"Theme"})," ",A("select",{value:o,onChange:h=>a(h.currentTarget.value),children:[A("option",{value:"auto",children:"auto"}),A("option",{value:"light",children:"light"}),A("option",{value:"dark",children:"dark"})]})]}),to.get()!==null&&A("button",{onClick:()=>{to.set(null),i(!0)},children:"Forget key"})]})]}),A("main",{id:"main",tabIndex:-1,children:u}),A("footer",{children:["homolog ",s," · ",A("a",{href:new URL("docs/",document.baseURI.split("#")[0]).href,children:"API"})," · ",A("a",{href:new URL("assets/licenses.txt",document.baseURI.split("#")[0]).href,children:"licenses"})]})]})}Pp(A(DA,{}),document.getElementById("app"));
