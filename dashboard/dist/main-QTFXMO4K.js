var Ot,Fm,zv,cr,gf,rc,Um,tc,Bm,xf,_f,Vv,Fa=Symbol.for("pv"),oc={},ac=[],Gv=/^m(i|n|o|s|text|space)$/,yf=Array.isArray,km=ac.slice,Or=Object.assign;function Dr(n){n&&n.parentNode&&n.remove()}function nc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Fa,__v:s||++Fm,__i:-1,__u:0};return!s&&Ot.vnode&&Ot.vnode(r),r}function Et(n){return n.children}function ic(n,e){this.props=n,this.context=e,this.__g=0}function ur(n,e){if(e==null)return n.__&&ur(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:ur(n)}function Hv(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Or({constructor:Fa},t)).__v=t.__v+1,Ot.vnode&&Ot.vnode(e),vf(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||ur(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Xm(s,e,r),t.__=t.__e=null,e.__e!=i&&zm(e))}function zm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),zm(n)}function Dm(n){(8&n.__g||(n.__g|=8,cr.push(n),rc++))&&gf==Ot.debounceRendering||((gf=Ot.debounceRendering)||queueMicrotask)(Vm)}function Vm(){try{for(var n,e=1;cr.length;)cr.length>e&&cr.sort(Um),n=cr.shift(),e=cr.length,8&n.__g&&Hv(n)}finally{(rc=cr.length)&&(gf||queueMicrotask)(Vm)}}function Gm(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,y,v,g,_=i.__k||ac,m=e.length;for(l=Wv(t,e,_,l,m),h=0;h<m;h++)(d=t.__k[h])!=null&&(f=~d.__i&&_[d.__i]||oc,d.__i=h,g=vf(n,d,f,s,r,o,a,l,c,u),y=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&bf(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||y,d)),v=v||y,4&d.__u?(l=Hm(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:y&&(l=y.nextSibling),d.__u&=-21);return t.__e=v,l}function Wv(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,y=t.length,v=y,g=0,_=0,m=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=m[r]=nc(null,o):yf(o)?o=m[r]=nc(Et,{children:o}):o.constructor===Fa&&o.__b?o=m[r]=nc(o.type,o.props,o.key,o.ref,o.__v):m[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Xv(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,_=1)):(~c||(s>y?g--:s<y&&g++),typeof o.type!="function"&&(o.__u|=4))):m[r]=null;if(_){for(u=[],h=[],r=0;r<s;r++)if((o=m[r])&&16&o.__u){for(g=0,f=u.length;g<f;)u[d=g+f>>1]<o.__i?g=d+1:f=d;u[g]=o.__i,h[r]=g+1}for(g=u.length;r--;)h[r]&&(h[r]==g?g--:m[r].__u|=4)}if(v)for(r=0;r<y;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=ur(a)),Sf(a,a));return i}function Hm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Hm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=ur(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Xv(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Om(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function ec(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Om(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Om(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=_f[e]||(_f[e]=$v(e)),(n.__a||(n.__a={}))[e]=xf,r=e!=(e=e.replace(Bm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function $v(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[tc]==null)e[tc]=xf++;else if(e[tc]<this.__a[n])return;return t(Ot.event?Ot.event(e):e)}}}function vf(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,y,v,g,_,m,S,b,T,M,p,w,L,P,N,I=e.type;if(e.constructor!==Fa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=sc(u,r):r.push(u),a=r[0]||a),(u=Ot.__b)&&u(e);e:if(typeof I=="function"){f=o.length;try{if(_=e.props,m=(u=I.prototype)&&u.render,S=(u=I.contextType)&&i[u.__c],b=u?S?S.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(m?e.__c=d=new I(_,b):(e.__c=d=new ic(_,b),d.constructor=I,d.render=Yv),S&&S.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),m&&(d.__s||(d.__s=d.state),I.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Or({},d.__s)),Or(d.__s,I.getDerivedStateFromProps(_,d.__s)))),y=d.props,v=d.state,d.__v=e,t.__c){if(_!==y&&m&&!I.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(_,b),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(_,d.__s,b)===!1){e.__v!=t.__v&&(d.props=_,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(U){U&&(U.__=e)}),ac.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=ur(t);break e}d.componentWillUpdate&&d.componentWillUpdate(_,d.__s,b),m&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(y,v,g)})}else m&&!I.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),m&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=b,d.props=_,d.__P=n,d.__g&=-5,T=Ot.__r,M=m?25:0;do d.__g&=-9,T&&T(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++M<25);m&&(ac.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Or({},i,d.getChildContext())),m&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(y,v)),p=u&&u.type===Et&&u.key==null?u.props.children:u,_.__P&&(u=a,s=(n=_.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(U){U&&Sf(U,U)}),t.__k=null),a=t.__k?ur(t,0):null),a=Gm(n,yf(p)?p:[p],e,t,i,s,r,o,a,l,c),_.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Dr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(U){if(o.length=f,e.__v=null,l||r)if(U&&U.then){if(e.__u|=128|l,r){for(~(P=r.indexOf(a||void 0))||(P=r.length);(N=r[P-1])&&N.nodeType==8;)P--;for(;P<r.length;P++)if(N=r[P])if(r[P]=null,w){if(N==L)break}else{if(N.nodeType!=8)break;N.data.startsWith("$s")&&(L=sc(w=N))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=sc(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Dr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),U&&U.then||Wm(e),Ot.__e(U,e,t)}}else a=e.__e=qv(t.__e,e,t,i,s,r,o,l,c,n);return(u=Ot.diffed)&&u(e),a}function sc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Wm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Wm))}function Xm(n,e,t){for(var i=0;i<t.length;)bf(t[i++],t[i++],t[i++]);Ot.__c&&Ot.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Ot.__e(r,s.__v)}})}function qv(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,y,v,g,_,m=t.props||oc,S=e.props,b=e.type;if(b=="svg"?s="http://www.w3.org/2000/svg":b=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((y=r[u])&&(b?y.localName==b:y.nodeType==3)){n=y,r[u]=null;break}}if(!n){if(_=c.ownerDocument||document,!b)return _.createTextNode(S);n=_.createElementNS(s,b,S.is?S:c),a&&(Ot.__m&&Ot.__m(e,r),a=!1),r=null}if(b){if(c=b=="template"&&n.content||n,r=b=="textarea"&&S.defaultValue!=null?null:r&&km.call(c.childNodes),!a&&r)for(m={},u=0;u<n.attributes.length;u++)m[(y=n.attributes[u]).name]=y.value;for(u in m)y=m[u],u=="dangerouslySetInnerHTML"?f=y:u=="children"||u in S||u=="value"&&"defaultValue"in S||u=="checked"&&"defaultChecked"in S||ec(n,u,null,y,s);for(u in S)y=S[u],u=="children"?d=y:u=="dangerouslySetInnerHTML"?h=y:u=="value"?v=y:u=="checked"?g=y:a&&typeof y!="function"||m[u]===y||ec(n,u,y,m[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(b=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Gv.test(b))&&(s="http://www.w3.org/1999/xhtml"),Gm(c,yf(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&ur(t,0),a,l),r&&r.some(Dr)),a&&b!="textarea"||(u="value",b=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(b!="progress"||v)||ec(n,u,v,m[u],s),u="checked",g!=null&&g!=n[u]&&ec(n,u,g,m[u],s))}else m===S||a&&n.data==S||(n.data=S);return n}function bf(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Ot.__e(s,t)}}function Sf(n,e,t){var i,s,r,o;if(Ot.unmount&&Ot.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||bf(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Ot.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Sf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=sc(i,r=[]))&&(i==n.__e&&r.some(Dr),Dr(s),Dr(i)),t||Dr(n.__e),n.__e=n.__c=n.__=null}function Yv(n,e,t){return this.constructor(n,t)}function $m(n,e){var t,i,s,r;Ot.__&&Ot.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=nc(Et,{children:[n]}),s=[],r=[],vf(e,e.__k,i||oc,oc,e.namespaceURI,i?null:e.firstChild?km.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Xm(s,e.__k,r),e.__k.props.children=null}Ot={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw rc=0,n}},Fm=0,zv=function(n){return n!=null&&n.constructor===Fa},ic.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Or({},this.state)),typeof n=="function"&&(n=n(Or({},t),this.props)),n&&(Or(t,n),this.__v&&(e&&this.__k.push(e),Dm(this)))},ic.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Dm(this))},ic.prototype.render=Et,cr=[],rc=0,Um=function(n,e){return n.__v.__b-e.__v.__b},tc=Symbol(),Bm=/(PointerCapture)$|Capture$/i,xf=0,_f={},Vv=0;var To,yn,Mf,qm,wf=Object.is,lc=0,ng=[],Tf=[],fn=Ot,Ym=fn.__b,Jm=fn.__r,jm=fn.diffed,Zm=fn.__c,Km=fn.unmount,Qm=fn.__;function cc(n,e){fn.__h&&fn.__h(yn,n,lc||e),lc=0;var t=yn.__H||(yn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function pe(n){return lc=1,Jv(sg,n)}function Jv(n,e,t){var i=cc(To++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):sg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);wf(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=yn,!yn.__f)){yn.__f=!0;var s=yn.shouldComponentUpdate;yn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,wf(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function mt(n,e){var t=cc(To++,3);!fn.__s&&Ef(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,yn.__H.__h.push(t))}function ig(n,e){var t=cc(To++,4);!fn.__s&&Ef(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,yn.__h.push(t))}function Xt(n){return lc=5,ai(function(){return{current:n}},[])}function ai(n,e){var t=cc(To++,7);return Ef(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function jv(){var n;do{for(;n=Tf.shift();)try{Ua(n)}catch(t){fn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=ng.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ua),e.__h.some(Af),e.__h=[]}catch(t){e.__h=[],fn.__e(t,n.__v)}}}while(Tf.length)}fn.__b=function(n){yn=null,Ym&&Ym(n)},fn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Qm&&Qm(n,e)},fn.__r=function(n){Jm&&Jm(n),To=0;var e=(yn=n.__c).__H;e&&(Mf==yn?yn.__h=[]:(e.__h.some(Ua),e.__h.some(Af),To=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Mf=yn},fn.diffed=function(n){jm&&jm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&tg(ng.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Mf=yn=null},fn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ua),t.__h=t.__h.filter(function(i){return!i.__||Af(i)})}catch(i){t.__h=[function(){throw i}]}}),Zm&&Zm(n,e)},fn.unmount=function(n){Km&&Km(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,tg(Tf.push(s))}else Ua(s)}catch(r){e=r}}),i.__H=void 0,e&&fn.__e(e,i.__v))};var eg=typeof requestAnimationFrame=="function";function Zv(n){var e,t=function(){clearTimeout(i),eg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);eg&&(e=requestAnimationFrame(t))}function tg(n){n!=1&&qm==fn.requestAnimationFrame||((qm=fn.requestAnimationFrame)||Zv)(jv)}function Ua(n){var e=yn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),yn=e}function Af(n){var e=yn;n.__c=n.__(),yn=e}function Ef(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!wf(t,n[i])})}function sg(n,e){return typeof e=="function"?e(n):e}var hc=["queued","running","succeeded","failed","cancelled","expired","dead"],Ba=n=>n.phase==="displacement"&&n.energy!==void 0,hi=class extends Error{constructor(t){super(t.detail??t.title);this.problem=t}problem},Cf="homolog-key",uc=[],Fr={get:()=>sessionStorage.getItem(Cf),set(n){n===null?sessionStorage.removeItem(Cf):sessionStorage.setItem(Cf,n)}};function rg(n){return uc.push(n),()=>{uc=uc.filter(e=>e!==n)}}var fc=n=>new URL(n,document.baseURI.split("#")[0]);async function Vn(n,e={}){let t=new Headers(e.headers),i=Fr.get();i!==null&&t.set("authorization",`Bearer ${i}`);let s=await fetch(fc(n),{...e,headers:t,cache:e.cache??"no-cache"});if(s.status===401&&uc.forEach(o=>o()),s.ok||s.status===304)return s;let r={type:"about:blank",title:s.statusText,status:s.status};try{r=await s.json()}catch{}throw new hi(r)}async function Mt(n,e){return(await Vn(n,{signal:e})).json()}async function $n(n,e,t){let i={method:n};return t!==void 0&&(i.body=JSON.stringify(t),i.headers={"content-type":"application/json"}),(await Vn(e,i)).json()}async function Rf(n,e){let t=e?window.open("","_blank"):null;t&&(t.opener=null);try{let{ticket:i}=Fr.get()===null?{ticket:null}:await $n("POST","v1/tickets",{path:`/${n}`}),s=fc(`${n}${vi({ticket:i})}`).href;t?t.location.href=s:location.assign(s)}catch(i){throw t?.close(),i}}async function dc(n,e){ka(await(await Vn(n)).blob(),e)}function ka(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function vi(n){let e=Object.entries(n).filter(([,i])=>i!=null&&i!==""),t=new URLSearchParams(e.map(([i,s])=>[i,String(s)])).toString();return t===""?"":`?${t}`}var jt=n=>{if(n instanceof hi){let e=n.problem.errors?.map(t=>`${t.pointer}: ${t.detail}`).join("; ");return[n.problem.title,n.problem.detail,e].filter(Boolean).join(": ")}return n instanceof TypeError?"The service cannot be reached.":String(n)};function Re(n,e=3){return n==null||!Number.isFinite(n)?"–":Number.isInteger(n)?n.toLocaleString("en"):n.toLocaleString("en",{maximumSignificantDigits:e})}var bi=n=>n==null?"–":`${n.toFixed(2)} mm`,Ao=n=>`${(100*n).toFixed(n>.995||n<.1?1:0)} %`;function Di(n){if(n<1e3)return`${Math.round(n)} ms`;let e=n/1e3;return e<60?`${e.toFixed(1)} s`:e<3600?`${Math.floor(e/60)} min ${Math.round(e%60)} s`:e<86400?`${Math.floor(e/3600)} h ${Math.round(e%3600/60)} min`:`${Math.floor(e/86400)} d ${Math.round(e%86400/3600)} h`}var ms=(n,e)=>{let t=e-Date.parse(n);return t<1e3?"now":Di(Math.floor(t/1e3)*1e3).replace(".0 s"," s")},pc=n=>n<1024?`${n} B`:n<1<<20?`${(n/1024).toFixed(1)} KiB`:`${(n/(1<<20)).toFixed(1)} MiB`,Zt=n=>n.replaceAll("_"," "),qn=n=>n!=="queued"&&n!=="running",Yn=n=>n.slice(-8),Kv={unlike_shape:{meaning:"Corresponding points differ in curvature or direction, or one surface is much longer than the other.",check:"Do both files show the same structure? Is a part of one missing?"},other_handedness:{meaning:"A mirrored source fits better.",check:"Is one file a left structure and the other a right one, or does an image have a flipped axis?"},uncertain_side:{meaning:"A file states two orientations of different handedness: left and right may be exchanged.",check:"Which orientation of the file is right? Write it into both places (sform and qform)."},units_differ:{meaning:"The sizes differ by the ratio of two units of length.",check:"Are both files in millimetres? Scale one of them, or state its unit in the file."},ambiguous_pose:{meaning:"A different pose fits as well.",check:"Is the shape nearly symmetric? Landmarks resolve it: submit again with a few corresponding points."},piece_dropped:{meaning:"A structure is in several pieces, and one that was dropped has 5 % or more of its volume.",check:"Are left and right one label, or several structures? Choose the labels of one, or name the repair largest_component."},labels_joined:{meaning:"Several labels of one input were joined, and the other input has other labels.",check:"Which labels are the structure? Submit again with them."},cavity_filled:{meaning:"A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much.",check:"Is the label a wall around something else? Name the repair fill to confirm that the inside belongs to it."},second_opinion:{meaning:"The default method finds another pose for these surfaces, or other corresponding points.",check:"Which of the two answers is right? Submit again with the method balanced, and look at both."},too_coarse:{meaning:"The voxels are so large for the structure that they leave its rotation uncertain.",check:"Is there a segmentation of smaller voxels? Interpolating this one adds nothing."}};function og(n){if(n.state==="succeeded"){if(n.reliable===!0)return{tone:"good",mark:"✓",title:"Reliable",lines:[`No check found a fault. ${n.surface_distance?`The registered surfaces are ${bi(n.surface_distance.mean_mm)} apart on average.`:""}`,...n.warnings??[]],next:"Look for colors that jump in the picture below; if there are none, keep this match."};if(n.reliable===!1){let i=(n.unreliable_reasons??[]).map(s=>Kv[s]??{meaning:Zt(s),check:""});return{tone:"bad",mark:"✕",title:"Not reliable",lines:[...i.map(s=>s.meaning),...n.warnings??[]],next:i.map(s=>s.check).join(" ")}}return{tone:"neutral",mark:"?",title:"Not checked",lines:["This method fits no displacement field, which the checks are made of.",...n.warnings??[]],next:"Judge by the picture, or match again with the method balanced."}}let t={queued:{tone:"wait",mark:"…",title:"Waiting",lines:[n.queue_position?`Number ${n.queue_position} in the queue.`:"In the queue."],next:"It starts when a worker is free."},running:{tone:"wait",mark:"…",title:n.cancel_requested?"Being cancelled":"Running",lines:[n.eta_ms?`About ${Di(n.eta_ms)} left.`:"The verdict comes with the result."],next:"The energy below shows how the match improves; each round begins anew."},cancelled:{tone:"neutral",mark:"–",title:"Cancelled",lines:["It has no result."],next:"Submit it again with Retry."},expired:{tone:"bad",mark:"✕",title:"Expired",lines:["It had not started by its deadline."],next:"Submit it again with Retry, or with a later deadline."}}[n.state];return t||{tone:"bad",mark:"✕",title:n.state==="dead"?"Given up":"Failed",lines:[[n.error?.title,n.error?.detail].filter(Boolean).join(": ")||"It has no result."],next:n.state==="dead"?"Its workers crashed too often. Retry once; if it fails again, report it.":"Correct the input, then submit it again."}}function mc(n){if(n.state!=="succeeded")return{tone:"neutral",text:""};if(n.reliable===!0)return{tone:"good",text:"✓ reliable"};let[e,...t]=n.unreliable_reasons??[];return n.reliable===!1?{tone:"bad",text:`✕ ${Zt(e??"not reliable")}${t.length>0?` and ${t.length} more`:""}`}:{tone:"neutral",text:"not checked"}}var Qv="uplot",eb="u-hz",tb="u-vt",nb="u-title",ib="u-wrap",sb="u-under",rb="u-over",ob="u-axis",kr="u-off",ab="u-select",lb="u-cursor-x",cb="u-cursor-y",ub="u-cursor-pt",hb="u-legend",fb="u-live",db="u-inline",pb="u-series",mb="u-marker",ag="u-label",gb="u-value",Va="width",Ga="height";var lg="bottom",Eo="left",Pf="right",qf="#000",cg=qf+"0",If="mousemove",ug="mousedown",Lf="mouseup",hg="mouseenter",fg="mouseleave",dg="dblclick",_b="resize",xb="scroll",pg="change",vc="dppxchange",Yf="--",Do=typeof window<"u",Uf=Do?document:null,Ro=Do?window:null,yb=Do?navigator:null,Ct,gc;function Bf(){let n=devicePixelRatio;Ct!=n&&(Ct=n,gc&&zf(pg,gc,Bf),gc=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),zr(pg,gc,Bf),Ro.dispatchEvent(new CustomEvent(vc)))}function Si(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function kf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function $i(n,e,t,i){let s=Uf.createElement(n);return e!=null&&Si(s,e),t?.insertBefore(s,i),s}function Oi(n,e){return $i("div",n,e)}var mg=new WeakMap;function gs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=mg.get(n);r!=o&&(n.style.transform=r,mg.set(n,r),e<0||t<0||e>i||t>s?Si(n,kr):kf(n,kr))}var gg=new WeakMap;function _g(n,e,t){let i=e+t,s=gg.get(n);i!=s&&(gg.set(n,i),n.style.background=e,n.style.borderColor=t)}var xg=new WeakMap;function yg(n,e,t,i){let s=e+""+t,r=xg.get(n);s!=r&&(xg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Jf={passive:!0},vb={...Jf,capture:!0};function zr(n,e,t,i){e.addEventListener(n,t,i?vb:Jf)}function zf(n,e,t,i){e.removeEventListener(n,t,Jf)}Do&&Bf();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function qg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Yg=n=>n!=null,Jg=n=>n!=null&&n>0,Mc=qg(Yg),bb=qg(Jg);function Sb(n,e,t,i=0,s=!1){let r=s?bb:Mc,o=s?Jg:Yg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function wc(n,e,t,i){let s=Sg(n),r=Sg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ns:jg,a=s==1?Mi:Fi,l=r==1?Fi:Mi,c=a(o(En(n))),u=l(o(En(e))),h=Po(t,c),f=Po(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(f=Gt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=e0(n,h),e=Tc(e,f)),[n,e]}function jf(n,e,t,i){let s=wc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Zf=.1,vg={mode:3,pad:Zf},Wa={pad:0,soft:null,mode:0},Mb={min:Wa,max:Wa};function bc(n,e,t,i){return Ac(t)?bg(n,e,t):(Wa.pad=t,Wa.soft=i?0:null,Wa.mode=i?3:0,bg(n,e,Mb))}function Tt(n,e){return n??e}function wb(n,e,t){for(e=Tt(e,0),t=Tt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function bg(n,e,t){let i=t.min,s=t.max,r=Tt(i.pad,0),o=Tt(s.pad,0),a=Tt(i.hard,-Vt),l=Tt(s.hard,Vt),c=Tt(i.soft,Vt),u=Tt(s.soft,-Vt),h=Tt(i.mode,0),f=Tt(s.mode,0),d=e-n,y=Ns(d),v=li(En(n),En(e)),g=Ns(v),_=En(g-y);(d<1e-24||_>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Vt&&(r=0),f==2&&u!=-Vt&&(o=0)));let m=d||v||1e3,S=Ns(m),b=Po(10,Mi(S)),T=m*(d==0?n==0?.1:1:r),M=Gt(e0(n-T,b/10),24),p=n>=c&&(h==1||h==3&&M<=c||h==2&&M>=c)?c:Vt,w=li(a,M<p&&n>=p?p:Yi(p,M)),L=m*(d==0?e==0?.1:1:o),P=Gt(Tc(e+L,b/10),24),N=e<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-Vt,I=Yi(l,P>N&&e<=N?N:li(N,P));return w==I&&w==0&&(I=100),[w,I]}var Tb=new Intl.NumberFormat(Do?yb.language:"en-US"),Kf=n=>Tb.format(n),wi=Math,yc=wi.PI,En=wi.abs,Mi=wi.floor,An=wi.round,Fi=wi.ceil,Yi=wi.min,li=wi.max,Po=wi.pow,Sg=wi.sign,Ns=wi.log10,jg=wi.log2,Ab=(n,e=1)=>wi.sinh(n)*e,Nf=(n,e=1)=>wi.asinh(n/e),Vt=1/0;function Mg(n){return(Ns((n^n>>31)-(n>>31))|0)+1}function Vf(n,e,t){return Yi(li(n,e),t)}function Zg(n){return typeof n=="function"}function yt(n){return Zg(n)?n:()=>n}var Eb=()=>{},Kg=n=>n,Qg=(n,e)=>e,Cb=n=>null,wg=n=>!0,Tg=(n,e)=>n==e,Rb=/\.\d*?(?=9{6,}|0{6,})/gm,Vr=n=>{if(n0(n)||fr.has(n))return n;let e=`${n}`,t=e.match(Rb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Vr(s)}e${r}`}return Gt(n,i)};function Ur(n,e){return Vr(Gt(Vr(n/e))*e)}function Tc(n,e){return Vr(Fi(Vr(n/e))*e)}function e0(n,e){return Vr(Mi(Vr(n/e))*e)}function Gt(n,e=0){if(n0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return An(i)/t}var fr=new Map;function t0(n){return((""+n).split(".")[1]||"").length}function $a(n,e,t,i){let s=[],r=i.map(t0);for(let o=e;o<t;o++){let a=En(o),l=Gt(Po(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Gt(u,h);s.push(f),fr.set(f,h)}}return s}var Xa={},Qf=[],Io=[null,null],hr=Array.isArray,n0=Number.isInteger,Pb=n=>n===void 0;function Ag(n){return typeof n=="string"}function Ac(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Ib(n){return n!=null&&typeof n=="object"}var Lb=Object.getPrototypeOf(Uint8Array),i0="__proto__";function Lo(n,e=Ac){let t;if(hr(n)){let i=n.find(s=>s!=null);if(hr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Lo(n[s],e)}else t=n.slice()}else if(n instanceof Lb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=i0&&(t[i]=Lo(n[i],e))}else t=n;return t}function vn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=i0&&(Ac(n[s])?vn(n[s],Lo(i[s])):n[s]=Lo(i[s]))}return n}var Nb=0,Db=1,Ob=2;function Fb(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Ub(n,e){if(zb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Vb(o[0])||(o=kb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:Db,d=[];for(let y=0;y<u.length;y++){let v=u[y],g=r.get(l[y]);v===null?f!=Nb&&(h[g]=v,f==Ob&&d.push(g)):h[g]=v}Fb(h,d,s),i.push(h)}}return i}var Bb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function kb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function zb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Vb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=li(1,Mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var s0=["January","February","March","April","May","June","July","August","September","October","November","December"],r0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function o0(n){return n.slice(0,3)}var Gb=r0.map(o0),Hb=s0.map(o0),Wb={MMMM:s0,MMM:Hb,WWWW:r0,WWW:Gb};function za(n){return(n<10?"0":"")+n}function Xb(n){return(n<10?"00":n<100?"0":"")+n}var $b={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>za(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>za(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>za(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>za(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>za(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Xb(n.getMilliseconds())};function ed(n,e){e=e||Wb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?$b[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var qb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Yb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==qb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var a0=n=>n%1==0,Sc=[1,2,2.5,5],Jb=$a(10,-32,0,Sc),l0=$a(10,0,32,Sc),jb=l0.filter(a0),Br=Jb.concat(l0),td=`
`,c0="{YYYY}",Eg=td+c0,u0="{M}/{D}",Ha=td+u0,_c=Ha+"/{YY}",h0="{aa}",Zb="{h}:{mm}",Co=Zb+h0,Cg=td+Co,Rg=":{ss}",Pt=null;function f0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?$a(10,0,3,Sc).filter(a0):$a(10,-3,0,Sc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,c0,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Eg,Pt,Pt,Pt,Pt,Pt,1],[s,u0,Eg,Pt,Pt,Pt,Pt,Pt,1],[i,"{h}"+h0,_c,Pt,Ha,Pt,Pt,Pt,1],[t,Co,_c,Pt,Ha,Pt,Pt,Pt,1],[e,Rg,_c+" "+Co,Pt,Ha+" "+Co,Pt,Cg,Pt,1],[n,Rg+".{fff}",_c+" "+Co,Pt,Ha+" "+Co,Pt,Cg,Pt,1]];function u(h){return(f,d,y,v,g,_)=>{let m=[],S=g>=o,b=g>=r&&g<o,T=h(y),M=Gt(T*n,3),p=Df(T.getFullYear(),S?0:T.getMonth(),b||S?1:T.getDate()),w=Gt(p*n,3);if(b||S){let L=b?g/r:0,P=S?g/o:0,N=M==w?M:Gt(Df(p.getFullYear()+P,p.getMonth()+L,1)*n,3),I=new Date(An(N/n)),U=I.getFullYear(),D=I.getMonth();for(let V=0;N<=v;V++){let Y=Df(U+P*V,D+L*V,1),W=Y-h(Gt(Y*n,3));N=Gt((+Y+W)*n,3),N<=v&&m.push(N)}}else{let L=g>=s?s:g,P=Mi(y)-Mi(M),N=w+P+Tc(M-w,L);m.push(N);let I=h(N),U=I.getHours()+I.getMinutes()/t+I.getSeconds()/i,D=g/i,V=f.axes[d]._space,Y=_/V;for(;N=Gt(N+g,n==1?0:3),!(N>v);)if(D>1){let W=Mi(Gt(U+D,6))%24,j=h(N).getHours()-W;j>1&&(j=-1),N-=j*i,U=(U+D)%24;let te=m[m.length-1];Gt((N-te)/g,3)*Y>=.7&&m.push(N)}else m.push(N)}return m}}return[l,c,u]}var[Kb,Qb,eS]=f0(1),[tS,nS,iS]=f0(.001);$a(2,-53,53,[1]);function Pg(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Ig(n,e){return(t,i,s,r,o)=>{let a=e.find(y=>o>=y[0])||e[e.length-1],l,c,u,h,f,d;return i.map(y=>{let v=n(y),g=v.getFullYear(),_=v.getMonth(),m=v.getDate(),S=v.getHours(),b=v.getMinutes(),T=v.getSeconds(),M=g!=l&&a[2]||_!=c&&a[3]||m!=u&&a[4]||S!=h&&a[5]||b!=f&&a[6]||T!=d&&a[7]||a[1];return l=g,c=_,u=m,h=S,f=b,d=T,M(v)})}}function sS(n,e){let t=ed(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Df(n,e,t){return new Date(n,e,t)}function Lg(n,e){return e(n)}var rS="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ng(n,e){return(t,i,s,r)=>r==null?Yf:e(n(i))}function oS(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function aS(n,e){return n.series[e].fill(n,e)}var lS={show:!0,live:!0,isolate:!1,mount:Eb,markers:{show:!0,width:2,stroke:oS,fill:aS,dash:"solid"},idx:null,idxs:null,values:[]};function cS(n,e){let t=n.cursor.points,i=Oi(),s=t.size(n,e);Kt(i,Va,s),Kt(i,Ga,s);let r=s/-2;Kt(i,"marginLeft",r),Kt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Kt(i,"borderWidth",o),i}function uS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function hS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function fS(n,e){return n.series[e].points.size}var Of=[0,0];function dS(n,e,t){return Of[0]=e,Of[1]=t,Of}function xc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Ff(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var pS={show:!0,x:!0,y:!0,lock:!1,move:dS,points:{one:!1,show:cS,size:fS,width:0,stroke:hS,fill:uS},bind:{mousedown:xc,mouseup:xc,click:xc,dblclick:xc,mousemove:Ff,mouseleave:Ff,mouseenter:Ff},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},d0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},nd=vn({},d0,{filter:Qg}),p0=vn({},nd,{size:10}),m0=vn({},d0,{show:!1}),id='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',g0="bold "+id,_0=1.5,Dg={show:!0,scale:"x",stroke:qf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:g0,side:2,grid:nd,ticks:p0,border:m0,font:id,lineGap:_0,rotate:0},mS="Value",gS="Time",Og={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function _S(n,e,t,i,s){return e.map(r=>r==null?"":Kf(r))}function xS(n,e,t,i,s,r,o){let a=[],l=fr.get(s)||0;t=o?t:Gt(Tc(t,s),l);for(let c=t;c<=i;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Gf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ns:jg,u=Mi(c(t));s=Po(l,u),l==10&&(s=Br[qi(s,Br)]);let h=t,f=s*l;l==10&&(f=Br[qi(f,Br)]);do a.push(h),h=h+s,l==10&&!fr.has(h)&&(h=Gt(h,fr.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Br[qi(f,Br)]));while(h<=i);return a}function yS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Gf(n,e,li(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Gf(n,e,li(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var x0=/./,vS=/[12357]/,bS=/[125]/,Fg=/1/,Hf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function SS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?x0:l(7,o)-u>=c?vS:l(5,o)-u>=c?bS:Fg;if(h==Fg){let f=En(l(1,o)-u);if(f<c)return Hf(e.slice().reverse(),a.distr,h,Fi(c/f)).reverse()}return Hf(e,a.distr,h,1)}function MS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?Hf(e.slice().reverse(),3,x0,Fi(a/c)).reverse():e}function wS(n,e,t,i){return i==null?Yf:e==null?"":Kf(e)}var Ug={show:!0,scale:"y",stroke:qf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:g0,side:3,grid:nd,ticks:p0,border:m0,font:id,lineGap:_0,rotate:0};function TS(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function AS(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var Bg={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},y0=(n,e,t,i,s)=>s,kg={show:!0,auto:!0,sorted:0,gaps:y0,alpha:1,facets:[vn({},Bg,{scale:"x"}),vn({},Bg,{scale:"y"})]},zg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:y0,alpha:1,points:{show:AS,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function ES(n,e,t,i,s){return t/10}var v0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},CS=vn({},v0,{time:!1,ori:1}),Vg={};function b0(n,e){let t=Vg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Vg[n]=t)),t}var No=1,Wf=2;function Gr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,y=a.width,v=a.height,g=n.valToPosH,_=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,_,f,d,y,v,Cc,Oo,Pc,M0,T0):t(s,l,c,u,h,_,g,d,f,v,y,Rc,Fo,od,w0,A0)}function sd(n,e){let t=0,i=0,s=Tt(n.bands,Qf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function RS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ds(n,e,t,i,s,r){return Gr(n,e,(o,a,l,c,u,h,f,d,y,v,g)=>{let _=o.pxRound,m=c.dir*(c.ori==0?1:-1),S=c.ori==0?Oo:Fo,b,T;m==1?(b=t,T=i):(b=i,T=t);let M=_(h(a[b],c,v,d)),p=_(f(l[b],u,g,y)),w=_(h(a[T],c,v,d)),L=_(f(r==1?u.max:u.min,u,g,y)),P=new Path2D(s);return S(P,w,L),S(P,M,L),S(P,M,p),P})}function Ec(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Pc:od,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function PS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function rd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),y=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let _=f+s;y=o>=0&&_>=0&&_<l?r(n[_]):y,y>=d&&a.push([d,y])}return a}function Gg(n){return n==0?Kg:n==1?An:e=>Ur(e,n)}function S0(n){let e=n==0?Cc:Rc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Yi(c,a/2,l/2),u=Yi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Cc=(n,e,t)=>{n.moveTo(e,t)},Rc=(n,e,t)=>{n.moveTo(t,e)},Oo=(n,e,t)=>{n.lineTo(e,t)},Fo=(n,e,t)=>{n.lineTo(t,e)},Pc=S0(0),od=S0(1),M0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},w0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},T0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},A0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function E0(n){return(e,t,i,s,r)=>Gr(e,t,(o,a,l,c,u,h,f,d,y,v,g)=>{let{pxRound:_,points:m}=o,S,b;c.ori==0?(S=Cc,b=M0):(S=Rc,b=w0);let T=Gt(m.width*Ct,3),M=(m.size-m.width)/2*Ct,p=Gt(M*2,3),w=new Path2D,L=new Path2D,{left:P,top:N,width:I,height:U}=e.bbox;Pc(L,P-p,N-p,I+p*2,U+p*2);let D=V=>{if(l[V]!=null){let Y=_(h(a[V],c,v,d)),W=_(f(l[V],u,g,y));S(w,Y+M,W),b(w,Y,W,M,0,yc*2)}};if(r)r.forEach(D);else for(let V=i;V<=s;V++)D(V);return{stroke:T>0?w:null,fill:w,clip:L,flags:No|Wf}})}function C0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var IS=C0(Oo),LS=C0(Fo);function R0(n){let e=Tt(n?.alignGaps,0);return(t,i,s,r)=>Gr(t,i,(o,a,l,c,u,h,f,d,y,v,g)=>{[s,r]=Mc(l,s,r);let _=o.pxRound,m=U=>_(h(U,c,v,d)),S=U=>_(f(U,u,g,y)),b,T;c.ori==0?(b=Oo,T=IS):(b=Fo,T=LS);let M=c.dir*(c.ori==0?1:-1),p={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},w=p.stroke,L=!1;if(r-s>=v*4){let U=K=>t.posToVal(K,c.key,!0),D=null,V=null,Y,W,ae,G=m(a[M==1?s:r]),j=m(a[s]),te=m(a[r]),ue=U(M==1?j+1:te-1);for(let K=M==1?s:r;K>=s&&K<=r;K+=M){let q=a[K],fe=(M==1?q<ue:q>ue)?G:m(q),ge=l[K];fe==G?ge!=null?(W=ge,D==null?(b(w,fe,S(W)),Y=D=V=W):W<D?D=W:W>V&&(V=W)):ge===null&&(L=!0):(D!=null&&T(w,G,S(D),S(V),S(Y),S(W)),ge!=null?(W=ge,b(w,fe,S(W)),D=V=Y=W):(D=V=null,ge===null&&(L=!0)),G=fe,ue=U(G+M))}D!=null&&D!=V&&ae!=G&&T(w,G,S(D),S(V),S(Y),S(W))}else for(let U=M==1?s:r;U>=s&&U<=r;U+=M){let D=l[U];D===null?L=!0:D!=null&&b(w,m(a[U]),S(D))}let[N,I]=sd(t,i);if(o.fill!=null||N!=0){let U=p.fill=new Path2D(w),D=o.fillTo(t,i,o.min,o.max,N),V=S(D),Y=m(a[s]),W=m(a[r]);M==-1&&([W,Y]=[Y,W]),b(U,W,V),b(U,Y,V)}if(!o.spanGaps){let U=[];L&&U.push(...rd(a,l,s,r,M,m,e)),p.gaps=U=o.gaps(t,i,s,r,U),p.clip=Ec(U,c.ori,d,y,v,g)}return I!=0&&(p.band=I==2?[Ds(t,i,s,r,w,-1),Ds(t,i,s,r,w,1)]:Ds(t,i,s,r,w,I)),p})}function NS(n){let e=Tt(n.align,1),t=Tt(n.ascDesc,!1),i=Tt(n.alignGaps,0),s=Tt(n.extend,!1);return(r,o,a,l)=>Gr(r,o,(c,u,h,f,d,y,v,g,_,m,S)=>{[a,l]=Mc(h,a,l);let b=c.pxRound,{left:T,width:M}=r.bbox,p=j=>b(y(j,f,m,g)),w=j=>b(v(j,d,S,_)),L=f.ori==0?Oo:Fo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},N=P.stroke,I=f.dir*(f.ori==0?1:-1),U=w(h[I==1?a:l]),D=p(u[I==1?a:l]),V=D,Y=D;s&&e==-1&&(Y=T,L(N,Y,U)),L(N,D,U);for(let j=I==1?a:l;j>=a&&j<=l;j+=I){let te=h[j];if(te==null)continue;let ue=p(u[j]),K=w(te);e==1?L(N,ue,U):L(N,V,K),L(N,ue,K),U=K,V=ue}let W=V;s&&e==1&&(W=T+M,L(N,W,U));let[ae,G]=sd(r,o);if(c.fill!=null||ae!=0){let j=P.fill=new Path2D(N),te=c.fillTo(r,o,c.min,c.max,ae),ue=w(te);L(j,W,ue),L(j,Y,ue)}if(!c.spanGaps){let j=[];j.push(...rd(u,h,a,l,I,p,i));let te=c.width*Ct/2,ue=t||e==1?te:-te,K=t||e==-1?-te:te;j.forEach(q=>{q[0]+=ue,q[1]+=K}),P.gaps=j=c.gaps(r,o,a,l,j),P.clip=Ec(j,f.ori,g,_,m,S)}return G!=0&&(P.band=G==2?[Ds(r,o,a,l,N,-1),Ds(r,o,a,l,N,1)]:Ds(r,o,a,l,N,G)),P})}function Hg(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=En(n[l]-n[a]);u<c&&(c=u,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function DS(n){n=n||Xa;let e=Tt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Tt(e[1],Vt),l=Tt(e[2],1),c=Tt(n.disp,Xa),u=Tt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,y,v,g)=>Gr(d,y,(_,m,S,b,T,M,p,w,L,P,N)=>{let I=_.pxRound,U=t,D=i*Ct,V=a*Ct,Y=l*Ct,W,ae;b.ori==0?[W,ae]=r(d,y):[ae,W]=r(d,y);let G=b.dir*(b.ori==0?1:-1),j=b.ori==0?Pc:od,te=b.ori==0?u:(Ie,je,at,Te,zt,We,qe)=>{u(Ie,je,at,zt,Te,qe,We)},ue=Tt(d.bands,Qf).find(Ie=>Ie.series[0]==y),K=ue!=null?ue.dir:0,q=_.fillTo(d,y,_.min,_.max,K),le=I(p(q,T,N,L)),fe,ge,xe,Ue=P,Je=I(_.width*Ct),Ge=!1,ft=null,ct=null,rt=null,en=null;h!=null&&(Je==0||f!=null)&&(Ge=!0,ft=h.values(d,y,v,g),ct=new Map,new Set(ft).forEach(Ie=>{Ie!=null&&ct.set(Ie,new Path2D)}),Je>0&&(rt=f.values(d,y,v,g),en=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&en.set(Ie,new Path2D)})));let{x0:Wt,size:dn}=c;if(Wt!=null&&dn!=null){U=1,m=Wt.values(d,y,v,g),Wt.unit==2&&(m=m.map(at=>d.posToVal(w+at*P,b.key,!0)));let Ie=dn.values(d,y,v,g);dn.unit==2?ge=Ie[0]*P:ge=M(Ie[0],b,P,w)-M(0,b,P,w),Ue=Hg(m,S,M,b,P,w,Ue),xe=Ue-ge+D}else Ue=Hg(m,S,M,b,P,w,Ue),xe=Ue*o+D,ge=Ue-xe;xe<1&&(xe=0),Je>=ge/2&&(Je=0),xe<5&&(I=Kg);let Ut=xe>0,In=Ue-xe-(Ut?Je:0);ge=I(Vf(In,Y,V)),fe=(U==0?ge/2:U==G?0:ge)-U*G*((U==0?D/2:0)+(Ut?Je/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},wn=Ge?null:new Path2D,rn=null;if(ue!=null)rn=d.data[ue.series[1]];else{let{y0:Ie,y1:je}=c;Ie!=null&&je!=null&&(S=je.values(d,y,v,g),rn=Ie.values(d,y,v,g))}let pn=W*ge,z=ae*ge;for(let Ie=G==1?v:g;Ie>=v&&Ie<=g;Ie+=G){let je=S[Ie];if(je==null)continue;if(rn!=null){let J=rn[Ie]??0;if(je-J==0)continue;le=p(J,T,N,L)}let at=b.distr!=2||c!=null?m[Ie]:Ie,Te=M(at,b,P,w),zt=p(Tt(je,q),T,N,L),We=I(Te-fe),qe=I(li(zt,le)),O=I(Yi(zt,le)),E=qe-O;if(je!=null){let J=je<0?z:pn,me=je<0?pn:z;Ge?(Je>0&&rt[Ie]!=null&&j(en.get(rt[Ie]),We,O+Mi(Je/2),ge,li(0,E-Je),J,me),ft[Ie]!=null&&j(ct.get(ft[Ie]),We,O+Mi(Je/2),ge,li(0,E-Je),J,me)):j(wn,We,O+Mi(Je/2),ge,li(0,E-Je),J,me),te(d,y,Ie,We-Je/2,O,ge+Je,E)}}return Je>0?St.stroke=Ge?en:wn:Ge||(St._fill=_.width==0?_._fill:_._stroke??_._fill,St.width=0),St.fill=Ge?ct:wn,St})}function OS(n,e){let t=Tt(e?.alignGaps,0);return(i,s,r,o)=>Gr(i,s,(a,l,c,u,h,f,d,y,v,g,_)=>{[r,o]=Mc(c,r,o);let m=a.pxRound,S=W=>m(f(W,u,g,y)),b=W=>m(d(W,h,_,v)),T,M,p;u.ori==0?(T=Cc,p=Oo,M=T0):(T=Rc,p=Fo,M=A0);let w=u.dir*(u.ori==0?1:-1),L=S(l[w==1?r:o]),P=L,N=[],I=[];for(let W=w==1?r:o;W>=r&&W<=o;W+=w)if(c[W]!=null){let G=l[W],j=S(G);N.push(P=j),I.push(b(c[W]))}let U={stroke:n(N,I,T,p,M,m),fill:null,clip:null,band:null,gaps:null,flags:No},D=U.stroke,[V,Y]=sd(i,s);if(a.fill!=null||V!=0){let W=U.fill=new Path2D(D),ae=a.fillTo(i,s,a.min,a.max,V),G=b(ae);p(W,P,G),p(W,L,G)}if(!a.spanGaps){let W=[];W.push(...rd(l,c,r,o,w,S,t)),U.gaps=W=a.gaps(i,s,r,o,W),U.clip=Ec(W,u.ori,y,v,g,_)}return Y!=0&&(U.band=Y==2?[Ds(i,s,r,o,D,-1),Ds(i,s,r,o,D,1)]:Ds(i,s,r,o,D,Y)),U})}function FS(n){return OS(US,n)}function US(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var Xf=new Set;function Wg(){for(let n of Xf)n.syncRect(!0)}Do&&(zr(_b,Ro,Wg),zr(xb,Ro,Wg,!0),zr(vc,Ro,()=>{Fn.pxRatio=Ct}));var BS=R0(),kS=E0();function Xg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>$f(r,o,e,t))}function zS(n,e){return n.map((t,i)=>i==0?{}:vn({},e,t))}function $f(n,e,t,i){return vn({},e==0?t:i,n)}function P0(n,e,t){return e==null?Io:[e,t]}var VS=P0;function GS(n,e,t){return e==null?Io:bc(e,t,Zf,!0)}function I0(n,e,t,i){return e==null?Io:wc(e,t,n.scales[i].log,!1)}var HS=I0;function L0(n,e,t,i){return e==null?Io:jf(e,t,n.scales[i].log,!1)}var WS=L0;function XS(n,e,t,i,s){let r=li(Mg(n),Mg(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?fr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function $g(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=An((t=+s)*Ct))+"px"),[n,e,t]}function $S(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(n,e,t){let i={mode:Tt(n.mode,1)},s=i.mode;function r(A,C,F,B){let $=C.valToPct(A);return B+F*(C.dir==-1?1-$:$)}function o(A,C,F,B){let $=C.valToPct(A);return B+F*(C.dir==-1?$:1-$)}function a(A,C,F,B){return C.ori==0?r(A,C,F,B):o(A,C,F,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Oi(Qv);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let A=Oi(nb,c);A.textContent=n.title}let u=$i("canvas"),h=i.ctx=u.getContext("2d"),f=Oi(ib,c);zr("click",f,A=>{A.target===y&&(qt!=vo||tn!=bo)&&zn.click(i,A)},!0);let d=i.under=Oi(sb,f);f.appendChild(u);let y=i.over=Oi(rb,f);n=Lo(n);let v=+Tt(n.pxAlign,1),g=Gg(v);(n.plugins||[]).forEach(A=>{A.opts&&(n=A.opts(i,n)||n)});let _=n.ms||.001,m=i.series=s==1?Xg(n.series||[],Og,zg,!1):zS(n.series||[null],kg),S=i.axes=Xg(n.axes||[],Dg,Ug,!0),b=i.scales={},T=i.bands=n.bands||[];T.forEach(A=>{A.fill=yt(A.fill||null),A.dir=Tt(A.dir,-1)});let M=s==2?m[1].facets[0].scale:m[0].scale,p={axes:Is,series:pt},w=(n.drawOrder||["axes","series"]).map(A=>p[A]);function L(A){let C=A.distr==3?F=>Ns(F>0?F:A.clamp(i,F,A.min,A.max,A.key)):A.distr==4?F=>Nf(F,A.asinh):A.distr==100?F=>A.fwd(F):F=>F;return F=>{let B=C(F),{_min:$,_max:ee}=A,he=ee-$;return(B-$)/he}}function P(A){let C=b[A];if(C==null){let F=(n.scales||Xa)[A]||Xa;if(F.from!=null){P(F.from);let B=vn({},b[F.from],F,{key:A});B.valToPct=L(B),b[A]=B}else{C=b[A]=vn({},A==M?v0:CS,F),C.key=A;let B=C.time,$=C.range,ee=hr($);if((A!=M||s==2&&!B)&&(ee&&($[0]==null||$[1]==null)&&($={min:$[0]==null?vg:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?vg:{mode:1,hard:$[1],soft:$[1]}},ee=!1),!ee&&Ac($))){let he=$;$=(_e,Me,Oe)=>Me==null?Io:bc(Me,Oe,he)}C.range=yt($||(B?VS:A==M?C.distr==3?HS:C.distr==4?WS:P0:C.distr==3?I0:C.distr==4?L0:GS)),C.auto=yt(ee?!1:C.auto),C.clamp=yt(C.clamp||ES),C._min=C._max=null,C.valToPct=L(C)}}}P("x"),P("y"),s==1&&m.forEach(A=>{P(A.scale)}),S.forEach(A=>{P(A.scale)});for(let A in n.scales)P(A);let N=b[M],I=N.distr,U,D;N.ori==0?(Si(c,eb),U=r,D=o):(Si(c,tb),U=o,D=r);let V={};for(let A in b){let C=b[A];(C.min!=null||C.max!=null)&&(V[A]={min:C.min,max:C.max},C.min=C.max=null)}let Y=n.tzDate||(A=>new Date(An(A/_))),W=n.fmtDate||ed,ae=_==1?eS(Y):iS(Y),G=Ig(Y,Pg(_==1?Qb:nS,W)),j=Ng(Y,Lg(rS,W)),te=[],ue=i.legend=vn({},lS,n.legend),K=i.cursor=vn({},pS,{drag:{y:s==2}},n.cursor),q=ue.show,le=K.show,fe=ue.markers;ue.idxs=te,fe.width=yt(fe.width),fe.dash=yt(fe.dash),fe.stroke=yt(fe.stroke),fe.fill=yt(fe.fill);let ge,xe,Ue,Je=[],Ge=[],ft,ct=!1,rt={};if(ue.live){let A=m[1]?m[1].values:null;ct=A!=null,ft=ct?A(i,1,0):{_:0};for(let C in ft)rt[C]=Yf}if(q)if(ge=$i("table",hb,c),Ue=$i("tbody",null,ge),ue.mount(i,ge),ct){xe=$i("thead",null,ge,Ue);let A=$i("tr",null,xe);$i("th",null,A);for(var en in ft)$i("th",ag,A).textContent=en}else Si(ge,db),ue.live&&Si(ge,fb);let Wt={show:!0},dn={show:!1};function Ut(A,C){if(C==0&&(ct||!ue.live||s==2))return Io;let F=[],B=$i("tr",pb,Ue,Ue.childNodes[C]);Si(B,A.class),A.show||Si(B,kr);let $=$i("th",null,B);if(fe.show){let _e=Oi(mb,$);if(C>0){let Me=fe.width(i,C);Me&&(_e.style.border=Me+"px "+fe.dash(i,C)+" "+fe.stroke(i,C)),_e.style.background=fe.fill(i,C)}}let ee=Oi(ag,$);A.label instanceof HTMLElement?ee.appendChild(A.label):ee.textContent=A.label,C>0&&(fe.show||(ee.style.color=A.width>0?fe.stroke(i,C):fe.fill(i,C)),St("click",$,_e=>{if(K._lock)return;Qe(_e);let Me=m.indexOf(A);if((_e.ctrlKey||_e.metaKey)!=ue.isolate){let Oe=m.some((Fe,ke)=>ke>0&&ke!=Me&&Fe.show);m.forEach((Fe,ke)=>{ke>0&&hs(ke,Oe?ke==Me?Wt:dn:Wt,!0,xn.setSeries)})}else hs(Me,{show:!A.show},!0,xn.setSeries)},!1),et&&St(hg,$,_e=>{K._lock||(Qe(_e),hs(m.indexOf(A),Mo,!0,xn.setSeries))},!1));for(var he in ft){let _e=$i("td",gb,B);_e.textContent="--",F.push(_e)}return[B,F]}let In=new Map;function St(A,C,F,B=!0){let $=In.get(C)||{},ee=K.bind[A](i,C,F,B);ee&&(zr(A,C,$[A]=ee),In.set(C,$))}function wn(A,C,F){let B=In.get(C)||{};for(let $ in B)(A==null||$==A)&&(zf($,C,B[$]),delete B[$]);A==null&&In.delete(C)}let rn=0,pn=0,z=0,Ie=0,je=0,at=0,Te=je,zt=at,We=z,qe=Ie,O=0,E=0,J=0,me=0;i.bbox={};let ce=!1,be=!1,Se=!1,ie=!1,re=!1,ye=!1;function k(A,C,F){(F||A!=i.width||C!=i.height)&&oe(A,C),ut(!1),Se=!0,be=!0,Xn()}function oe(A,C){i.width=rn=z=A,i.height=pn=Ie=C,je=at=0,we(),Xe();let F=i.bbox;O=F.left=Ur(je*Ct,.5),E=F.top=Ur(at*Ct,.5),J=F.width=Ur(z*Ct,.5),me=F.height=Ur(Ie*Ct,.5)}let se=3;function Ae(){let A=!1,C=0;for(;!A;){C++;let F=_o(C),B=us(C);A=C==se||F&&B,A||(oe(i.width,i.height),be=!0)}}function ve({width:A,height:C}){k(A,C)}i.setSize=ve;function we(){let A=!1,C=!1,F=!1,B=!1;S.forEach(($,ee)=>{if($.show&&$._show){let{side:he,_size:_e}=$,Me=he%2,Oe=$.label!=null?$.labelSize:0,Fe=_e+Oe;Fe>0&&(Me?(z-=Fe,he==3?(je+=Fe,B=!0):F=!0):(Ie-=Fe,he==0?(at+=Fe,A=!0):C=!0))}}),ls[0]=A,ls[1]=F,ls[2]=C,ls[3]=B,z-=Hi[1]+Hi[3],je+=Hi[3],Ie-=Hi[2]+Hi[0],at+=Hi[0]}function Xe(){let A=je+z,C=at+Ie,F=je,B=at;function $(ee,he){switch(ee){case 1:return A+=he,A-he;case 2:return C+=he,C-he;case 3:return F-=he,F+he;case 0:return B-=he,B+he}}S.forEach((ee,he)=>{if(ee.show&&ee._show){let _e=ee.side;ee._pos=$(_e,ee._size),ee.label!=null&&(ee._lpos=$(_e,ee.labelSize))}})}if(K.dataIdx==null){let A=K.hover,C=A.skip=new Set(A.skip??[]);C.add(void 0);let F=A.prox=yt(A.prox),B=A.bias??=0;K.dataIdx=($,ee,he,_e)=>{if(ee==0)return he;let Me=he,Oe=F($,ee,he,_e)??Vt,Fe=Oe>=0&&Oe<Vt,ke=N.ori==0?z:Ie,ot=K.left,At=e[0],wt=e[ee];if(C.has(wt[he])){Me=null;let _t=null,Ze=null,$e;if(B==0||B==-1)for($e=he;_t==null&&$e-- >0;)C.has(wt[$e])||(_t=$e);if(B==0||B==1)for($e=he;Ze==null&&$e++<wt.length;)C.has(wt[$e])||(Ze=$e);if(_t!=null||Ze!=null)if(Fe){let Jt=_t==null?-1/0:U(At[_t],N,ke,0),ln=Ze==null?1/0:U(At[Ze],N,ke,0),On=ot-Jt,Bt=ln-ot;On<=Bt?On<=Oe&&(Me=_t):Bt<=Oe&&(Me=Ze)}else Me=Ze==null?_t:_t==null?Ze:he-_t<=Ze-he?_t:Ze}else Fe&&En(ot-U(At[he],N,ke,0))>Oe&&(Me=null);return Me}}let Qe=A=>{K.event=A};K.idxs=te,K._lock=!1;let de=K.points;de.show=yt(de.show),de.size=yt(de.size),de.stroke=yt(de.stroke),de.width=yt(de.width),de.fill=yt(de.fill);let ze=i.focus=vn({},n.focus||{alpha:.3},K.focus),et=ze.prox>=0,Pe=et&&de.one,lt=[],$t=[],ni=[];function Ca(A,C){let F=de.show(i,C);if(F instanceof HTMLElement)return Si(F,ub),Si(F,A.class),gs(F,-10,-10,z,Ie),y.insertBefore(F,lt[C]),F}function po(A,C){if(s==1||C>0){let F=s==1&&b[A.scale].time,B=A.value;A.value=F?Ag(B)?Ng(Y,Lg(B,W)):B||j:B||wS,A.label=A.label||(F?gS:mS)}if(Pe||C>0){A.width=A.width==null?1:A.width,A.paths=A.paths||BS||Cb,A.fillTo=yt(A.fillTo||RS),A.pxAlign=+Tt(A.pxAlign,v),A.pxRound=Gg(A.pxAlign),A.stroke=yt(A.stroke||null),A.fill=yt(A.fill||null),A._stroke=A._fill=A._paths=A._focus=null;let F=TS(li(1,A.width),1),B=A.points=vn({},{size:F,width:li(1,F*.2),stroke:A.stroke,space:F*2,paths:kS,_stroke:null,_fill:null},A.points);B.show=yt(B.show),B.filter=yt(B.filter),B.fill=yt(B.fill),B.stroke=yt(B.stroke),B.paths=yt(B.paths),B.pxAlign=A.pxAlign}if(q){let F=Ut(A,C);Je.splice(C,0,F[0]),Ge.splice(C,0,F[1]),ue.values.push(null)}if(le){te.splice(C,0,null);let F=null;Pe?C==0&&(F=Ca(A,C)):C>0&&(F=Ca(A,C)),lt.splice(C,0,F),$t.splice(C,0,0),ni.splice(C,0,0)}Dn("addSeries",C)}function of(A,C){C=C??m.length,A=s==1?$f(A,C,Og,zg):$f(A,C,{},kg),m.splice(C,0,A),po(m[C],C)}i.addSeries=of;function jl(A){if(m.splice(A,1),q){ue.values.splice(A,1),Ge.splice(A,1);let C=Je.splice(A,1)[0];wn(null,C.firstChild),C.remove()}le&&(te.splice(A,1),lt.splice(A,1)[0].remove(),$t.splice(A,1),ni.splice(A,1)),Dn("delSeries",A)}i.delSeries=jl;let ls=[!1,!1,!1,!1];function Cs(A,C){if(A._show=A.show,A.show){let F=A.side%2,B=b[A.scale];B==null&&(A.scale=F?m[1].scale:M,B=b[A.scale]);let $=B.time;A.size=yt(A.size),A.space=yt(A.space),A.rotate=yt(A.rotate),hr(A.incrs)&&A.incrs.forEach(he=>{!fr.has(he)&&fr.set(he,t0(he))}),A.incrs=yt(A.incrs||(B.distr==2?jb:$?_==1?Kb:tS:Br)),A.splits=yt(A.splits||($&&B.distr==1?ae:B.distr==3?Gf:B.distr==4?yS:xS)),A.stroke=yt(A.stroke),A.grid.stroke=yt(A.grid.stroke),A.ticks.stroke=yt(A.ticks.stroke),A.border.stroke=yt(A.border.stroke);let ee=A.values;A.values=hr(ee)&&!hr(ee[0])?yt(ee):$?hr(ee)?Ig(Y,Pg(ee,W)):Ag(ee)?sS(Y,ee):ee||G:ee||_S,A.filter=yt(A.filter||(B.distr>=3&&B.log==10?SS:B.distr==3&&B.log==2?MS:Qg)),A.font=$g(A.font),A.labelFont=$g(A.labelFont),A._size=A.size(i,null,C,0),A._space=A._rotate=A._incrs=A._found=A._splits=A._values=null,A._size>0&&(ls[C]=!0,A._el=Oi(ob,f))}}function Rs(A,C,F,B){let[$,ee,he,_e]=F,Me=C%2,Oe=0;return Me==0&&(_e||ee)&&(Oe=C==0&&!$||C==2&&!he?An(Dg.size/3):0),Me==1&&($||he)&&(Oe=C==1&&!ee||C==3&&!_e?An(Ug.size/2):0),Oe}let Ra=i.padding=(n.padding||[Rs,Rs,Rs,Rs]).map(A=>yt(Tt(A,Rs))),Hi=i._padding=Ra.map((A,C)=>A(i,C,ls,0)),on,un=null,hn=null,cs=s==1?m[0].idxs:null,gi=null,ir=!1;function Pa(A,C){if(e=A??[],i.data=i._data=e,s==2){on=0;for(let F=1;F<m.length;F++)on+=e[F][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),gi=e[0],on=gi.length;let F=e;if(I==2){F=e.slice();let B=F[0]=Array(on);for(let $=0;$<on;$++)B[$]=$}i._data=e=F}if(ut(!0),Dn("setData"),I==2&&(Se=!0),C!==!1){let F=N;F.auto(i,ir)?Ia():or(M,F.min,F.max),ie=ie||K.left>=0,ye=!0,Xn()}}i.setData=Pa;function Ia(){ir=!0;let A,C;s==1&&(on>0?(un=cs[0]=0,hn=cs[1]=on-1,A=e[0][un],C=e[0][hn],I==2?(A=un,C=hn):A==C&&(I==3?[A,C]=wc(A,A,N.log,!1):I==4?[A,C]=jf(A,A,N.log,!1):N.time?C=A+An(86400/_):[A,C]=bc(A,C,Zf,!0))):(un=cs[0]=A=null,hn=cs[1]=C=null)),or(M,A,C)}let mo,sr,go,R,H,ne,Z,Q,Ee,Le;function Ce(A,C,F,B,$,ee){A??=cg,F??=Qf,B??="butt",$??=cg,ee??="round",A!=mo&&(h.strokeStyle=mo=A),$!=sr&&(h.fillStyle=sr=$),C!=go&&(h.lineWidth=go=C),ee!=H&&(h.lineJoin=H=ee),B!=ne&&(h.lineCap=ne=B),F!=R&&h.setLineDash(R=F)}function Ne(A,C,F,B){C!=sr&&(h.fillStyle=sr=C),A!=Z&&(h.font=Z=A),F!=Q&&(h.textAlign=Q=F),B!=Ee&&(h.textBaseline=Ee=B)}function He(A,C,F,B,$=0){if(B.length>0&&A.auto(i,ir)&&(C==null||C.min==null)){let ee=Tt(un,0),he=Tt(hn,B.length-1),_e=F.min==null?Sb(B,ee,he,$,A.distr==3):[F.min,F.max];A.min=Yi(A.min,F.min=_e[0]),A.max=li(A.max,F.max=_e[1])}}let it={min:null,max:null};function dt(){for(let B in b){let $=b[B];V[B]==null&&($.min==null||V[M]!=null&&$.auto(i,ir))&&(V[B]=it)}for(let B in b){let $=b[B];V[B]==null&&$.from!=null&&V[$.from]!=null&&(V[B]=it)}V[M]!=null&&ut(!0);let A={};for(let B in V){let $=V[B];if($!=null){let ee=A[B]=Lo(b[B],Ib);if($.min!=null)vn(ee,$);else if(B!=M||s==2)if(on==0&&ee.from==null){let he=ee.range(i,null,null,B);ee.min=he[0],ee.max=he[1]}else ee.min=Vt,ee.max=-Vt}}if(on>0){m.forEach((B,$)=>{if(s==1){let ee=B.scale,he=V[ee];if(he==null)return;let _e=A[ee];if($==0){let Me=_e.range(i,_e.min,_e.max,ee);_e.min=Me[0],_e.max=Me[1],un=qi(_e.min,e[0]),hn=qi(_e.max,e[0]),hn-un>1&&(e[0][un]<_e.min&&un++,e[0][hn]>_e.max&&hn--),B.min=gi[un],B.max=gi[hn]}else B.show&&B.auto&&He(_e,he,B,e[$],B.sorted);B.idxs[0]=un,B.idxs[1]=hn}else if($>0&&B.show&&B.auto){let[ee,he]=B.facets,_e=ee.scale,Me=he.scale,[Oe,Fe]=e[$],ke=A[_e],ot=A[Me];ke!=null&&He(ke,V[_e],ee,Oe,ee.sorted),ot!=null&&He(ot,V[Me],he,Fe,he.sorted),B.min=he.min,B.max=he.max}});for(let B in A){let $=A[B],ee=V[B];if($.from==null&&(ee==null||ee.min==null)){let he=$.range(i,$.min==Vt?null:$.min,$.max==-Vt?null:$.max,B);$.min=he[0],$.max=he[1]}}}for(let B in A){let $=A[B];if($.from!=null){let ee=A[$.from];if(ee.min==null)$.min=$.max=null;else{let he=$.range(i,ee.min,ee.max,B);$.min=he[0],$.max=he[1]}}}let C={},F=!1;for(let B in A){let $=A[B],ee=b[B];if(ee.min!=$.min||ee.max!=$.max){ee.min=$.min,ee.max=$.max;let he=ee.distr;ee._min=he==3?Ns(ee.min):he==4?Nf(ee.min,ee.asinh):he==100?ee.fwd(ee.min):ee.min,ee._max=he==3?Ns(ee.max):he==4?Nf(ee.max,ee.asinh):he==100?ee.fwd(ee.max):ee.max,C[B]=F=!0}}if(F){m.forEach((B,$)=>{s==2?$>0&&C.y&&(B._paths=null):C[B.scale]&&(B._paths=null)});for(let B in C)Se=!0,Dn("setScale",B);le&&K.left>=0&&(ie=ye=!0)}for(let B in V)V[B]=null}function Ve(A){let C=Vf(un-1,0,on-1),F=Vf(hn+1,0,on-1);for(;A[C]==null&&C>0;)C--;for(;A[F]==null&&F<on-1;)F++;return[C,F]}function pt(){if(on>0){let A=m.some(C=>C._focus)&&Le!=ze.alpha;A&&(h.globalAlpha=Le=ze.alpha),m.forEach((C,F)=>{if(F>0&&C.show&&(nn(F,!1),nn(F,!0),C._paths==null)){let B=Le;Le!=C.alpha&&(h.globalAlpha=Le=C.alpha);let $=s==2?[0,e[F][0].length-1]:Ve(e[F]);C._paths=C.paths(i,F,$[0],$[1]),Le!=B&&(h.globalAlpha=Le=B)}}),m.forEach((C,F)=>{if(F>0&&C.show){let B=Le;Le!=C.alpha&&(h.globalAlpha=Le=C.alpha),C._paths!=null&&Lt(F,!1);{let $=C._paths!=null?C._paths.gaps:null,ee=C.points.show(i,F,un,hn,$),he=C.points.filter(i,F,ee,$);(ee||he)&&(C.points._paths=C.points.paths(i,F,un,hn,he),Lt(F,!0))}Le!=B&&(h.globalAlpha=Le=B),Dn("drawSeries",F)}}),A&&(h.globalAlpha=Le=1)}}function nn(A,C){let F=C?m[A].points:m[A];F._stroke=F.stroke(i,A),F._fill=F.fill(i,A)}function Lt(A,C){let F=C?m[A].points:m[A],{stroke:B,fill:$,clip:ee,flags:he,_stroke:_e=F._stroke,_fill:Me=F._fill,_width:Oe=F.width}=F._paths;Oe=Gt(Oe*Ct,3);let Fe=null,ke=Oe%2/2;C&&Me==null&&(Me=Oe>0?"#fff":_e);let ot=F.pxAlign==1&&ke>0;if(ot&&h.translate(ke,ke),!C){let At=O-Oe/2,wt=E-Oe/2,_t=J+Oe,Ze=me+Oe;Fe=new Path2D,Fe.rect(At,wt,_t,Ze)}C?Be(_e,Oe,F.dash,F.cap,Me,B,$,he,ee):Nt(A,_e,Oe,F.dash,F.cap,Me,B,$,he,Fe,ee),ot&&h.translate(-ke,-ke)}function Nt(A,C,F,B,$,ee,he,_e,Me,Oe,Fe){let ke=!1;Me!=0&&T.forEach((ot,At)=>{if(ot.series[0]==A){let wt=m[ot.series[1]],_t=e[ot.series[1]],Ze=(wt._paths||Xa).band;hr(Ze)&&(Ze=ot.dir==1?Ze[0]:Ze[1]);let $e,Jt=null;wt.show&&Ze&&wb(_t,un,hn)?(Jt=ot.fill(i,At)||ee,$e=wt._paths.clip):Ze=null,Be(C,F,B,$,Jt,he,_e,Me,Oe,Fe,$e,Ze),ke=!0}}),ke||Be(C,F,B,$,ee,he,_e,Me,Oe,Fe)}let Tn=No|Wf;function Be(A,C,F,B,$,ee,he,_e,Me,Oe,Fe,ke){Ce(A,C,F,B,$),(Me||Oe||ke)&&(h.save(),Me&&h.clip(Me),Oe&&h.clip(Oe)),ke?(_e&Tn)==Tn?(h.clip(ke),Fe&&h.clip(Fe),xt($,he),mn(A,ee,C)):_e&Wf?(xt($,he),h.clip(ke),mn(A,ee,C)):_e&No&&(h.save(),h.clip(ke),Fe&&h.clip(Fe),xt($,he),h.restore(),mn(A,ee,C)):(xt($,he),mn(A,ee,C)),(Me||Oe||ke)&&h.restore()}function mn(A,C,F){F>0&&(C instanceof Map?C.forEach((B,$)=>{h.strokeStyle=mo=$,h.stroke(B)}):C!=null&&A&&h.stroke(C))}function xt(A,C){C instanceof Map?C.forEach((F,B)=>{h.fillStyle=sr=B,h.fill(F)}):C!=null&&A&&h.fill(C)}function Ps(A,C,F,B){let $=S[A],ee;if(B<=0)ee=[0,0];else{let he=$._space=$.space(i,A,C,F,B),_e=$._incrs=$.incrs(i,A,C,F,B,he);ee=XS(C,F,_e,B,he)}return $._found=ee}function gn(A,C,F,B,$,ee,he,_e,Me,Oe){let Fe=he%2/2;v==1&&h.translate(Fe,Fe),Ce(_e,he,Me,Oe,_e),h.beginPath();let ke,ot,At,wt,_t=$+(B==0||B==3?-ee:ee);F==0?(ot=$,wt=_t):(ke=$,At=_t);for(let Ze=0;Ze<A.length;Ze++)C[Ze]!=null&&(F==0?ke=At=A[Ze]:ot=wt=A[Ze],h.moveTo(ke,ot),h.lineTo(At,wt));h.stroke(),v==1&&h.translate(-Fe,-Fe)}function _o(A){let C=!0;return S.forEach((F,B)=>{if(!F.show)return;let $=b[F.scale];if($.min==null){F._show&&(C=!1,F._show=!1,ut(!1));return}else F._show||(C=!1,F._show=!0,ut(!1));let ee=F.side,he=ee%2,{min:_e,max:Me}=$,[Oe,Fe]=Ps(B,_e,Me,he==0?z:Ie);if(Fe==0)return;let ke=$.distr==2,ot=F._splits=F.splits(i,B,_e,Me,Oe,Fe,ke),At=$.distr==2?ot.map($e=>gi[$e]):ot,wt=$.distr==2?gi[ot[1]]-gi[ot[0]]:Oe,_t=F._values=F.values(i,F.filter(i,At,B,Fe,wt),B,Fe,wt);F._rotate=ee==2?F.rotate(i,_t,B,Fe):0;let Ze=F._size;F._size=Fi(F.size(i,_t,B,A)),Ze!=null&&F._size!=Ze&&(C=!1)}),C}function us(A){let C=!0;return Ra.forEach((F,B)=>{let $=F(i,B,ls,A);$!=Hi[B]&&(C=!1),Hi[B]=$}),C}function Is(){for(let A=0;A<S.length;A++){let C=S[A];if(!C.show||!C._show)continue;let F=C.side,B=F%2,$,ee,he=C.stroke(i,A),_e=F==0||F==3?-1:1,[Me,Oe]=C._found;if(C.label!=null){let ri=C.labelGap*_e,yi=An((C._lpos+ri)*Ct);Ne(C.labelFont[0],he,"center",F==2?"top":lg),h.save(),B==1?($=ee=0,h.translate(yi,An(E+me/2)),h.rotate((F==3?-yc:yc)/2)):($=An(O+J/2),ee=yi);let Nr=Zg(C.label)?C.label(i,A,Me,Oe):C.label;h.fillText(Nr,$,ee),h.restore()}if(Oe==0)continue;let Fe=b[C.scale],ke=B==0?J:me,ot=B==0?O:E,At=C._splits,wt=Fe.distr==2?At.map(ri=>gi[ri]):At,_t=Fe.distr==2?gi[At[1]]-gi[At[0]]:Me,Ze=C.ticks,$e=C.border,Jt=Ze.show?Ze.size:0,ln=An(Jt*Ct),On=An((C.alignTo==2?C._size-Jt-C.gap:C.gap)*Ct),Bt=C._rotate*-yc/180,cn=g(C._pos*Ct),_i=(ln+On)*_e,si=cn+_i;ee=B==0?si:0,$=B==1?si:0;let Li=C.font[0],Wi=C.align==1?Eo:C.align==2?Pf:Bt>0?Eo:Bt<0?Pf:B==0?"center":F==3?Pf:Eo,ds=Bt||B==1?"middle":F==2?"top":lg;Ne(Li,he,Wi,ds);let xi=C.font[1]*C.lineGap,Ni=At.map(ri=>g(a(ri,Fe,ke,ot))),Xi=C._values;for(let ri=0;ri<Xi.length;ri++){let yi=Xi[ri];if(yi!=null){B==0?$=Ni[ri]:ee=Ni[ri],yi=""+yi;let Nr=yi.indexOf(`
`)==-1?[yi]:yi.split(/\n/gm);for(let oi=0;oi<Nr.length;oi++){let Nm=Nr[oi];Bt?(h.save(),h.translate($,ee+oi*xi),h.rotate(Bt),h.fillText(Nm,0,0),h.restore()):h.fillText(Nm,$,ee+oi*xi)}}}Ze.show&&gn(Ni,Ze.filter(i,wt,A,Oe,_t),B,F,cn,ln,Gt(Ze.width*Ct,3),Ze.stroke(i,A),Ze.dash,Ze.cap);let ps=C.grid;ps.show&&gn(Ni,ps.filter(i,wt,A,Oe,_t),B,B==0?2:1,B==0?E:O,B==0?me:J,Gt(ps.width*Ct,3),ps.stroke(i,A),ps.dash,ps.cap),$e.show&&gn([cn],[1],B==0?1:0,B==0?1:2,B==1?E:O,B==1?me:J,Gt($e.width*Ct,3),$e.stroke(i,A),$e.dash,$e.cap)}Dn("drawAxes")}function ut(A){m.forEach((C,F)=>{F>0&&(C._paths=null,A&&(s==1?(C.min=null,C.max=null):C.facets.forEach(B=>{B.min=null,B.max=null})))})}let an=!1,ii=!1,Dt=[];function _n(){ii=!1;for(let A=0;A<Dt.length;A++)Dn(...Dt[A]);Dt.length=0}function Xn(){an||(Bb(mm),an=!0)}function Zl(A,C=!1){an=!0,ii=C,A(i),mm(),C&&Dt.length>0&&queueMicrotask(_n)}i.batch=Zl;function mm(){if(ce&&(dt(),ce=!1),Se&&(Ae(),Se=!1),be){if(Kt(d,Eo,je),Kt(d,"top",at),Kt(d,Va,z),Kt(d,Ga,Ie),Kt(y,Eo,je),Kt(y,"top",at),Kt(y,Va,z),Kt(y,Ga,Ie),Kt(f,Va,rn),Kt(f,Ga,pn),u.width=An(rn*Ct),u.height=An(pn*Ct),S.forEach(({_el:A,_show:C,_size:F,_pos:B,side:$})=>{if(A!=null)if(C){let ee=$===3||$===0?F:0,he=$%2==1;Kt(A,he?"left":"top",B-ee),Kt(A,he?"width":"height",F),Kt(A,he?"top":"left",he?at:je),Kt(A,he?"height":"width",he?Ie:z),kf(A,kr)}else Si(A,kr)}),mo=sr=go=H=ne=Z=Q=Ee=R=null,Le=1,Da(!0),je!=Te||at!=zt||z!=We||Ie!=qe){ut(!1);let A=z/We,C=Ie/qe;if(le&&!ie&&K.left>=0){K.left*=A,K.top*=C,xo&&gs(xo,An(K.left),0,z,Ie),yo&&gs(yo,0,An(K.top),z,Ie);for(let F=0;F<lt.length;F++){let B=lt[F];B!=null&&($t[F]*=A,ni[F]*=C,gs(B,Fi($t[F]),Fi(ni[F]),z,Ie))}}if(Yt.show&&!re&&Yt.left>=0&&Yt.width>0){Yt.left*=A,Yt.width*=A,Yt.top*=C,Yt.height*=C;for(let F in ff)Kt(So,F,Yt[F])}Te=je,zt=at,We=z,qe=Ie}Dn("setSize"),be=!1}rn>0&&pn>0&&(h.clearRect(0,0,u.width,u.height),Dn("drawClear"),w.forEach(A=>A()),Dn("draw")),Yt.show&&re&&(Kl(Yt),re=!1),le&&ie&&(Lr(null,!0,!1),ie=!1),ue.show&&ue.live&&ye&&(uf(),ye=!1),l||(l=!0,i.status=1,Dn("ready")),ir=!1,an=!1}i.redraw=(A,C)=>{Se=C||!1,A!==!1?or(M,N.min,N.max):Xn()};function af(A,C){let F=b[A];if(F.from==null){if(on==0){let B=F.range(i,C.min,C.max,A);C.min=B[0],C.max=B[1]}if(C.min>C.max){let B=C.min;C.min=C.max,C.max=B}if(on>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;A==M&&F.distr==2&&on>0&&(C.min=qi(C.min,e[0]),C.max=qi(C.max,e[0]),C.min==C.max&&C.max++),V[A]=C,ce=!0,Xn()}}i.setScale=af;let lf,cf,xo,yo,gm,_m,vo,bo,xm,ym,qt,tn,rr=!1,zn=K.drag,Ln=zn.x,Nn=zn.y;le&&(K.x&&(lf=Oi(lb,y)),K.y&&(cf=Oi(cb,y)),N.ori==0?(xo=lf,yo=cf):(xo=cf,yo=lf),qt=K.left,tn=K.top);let Yt=i.select=vn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),So=Yt.show?Oi(ab,Yt.over?y:d):null;function Kl(A,C){if(Yt.show){for(let F in A)Yt[F]=A[F],F in ff&&Kt(So,F,A[F]);C!==!1&&Dn("setSelect")}}i.setSelect=Kl;function Cv(A){if(m[A].show)q&&kf(Je[A],kr);else if(q&&Si(Je[A],kr),le){let F=Pe?lt[0]:lt[A];F!=null&&gs(F,-10,-10,z,Ie)}}function or(A,C,F){af(A,{min:C,max:F})}function hs(A,C,F,B){C.focus!=null&&Nv(A),C.show!=null&&m.forEach(($,ee)=>{ee>0&&(A==ee||A==null)&&($.show=C.show,Cv(ee),s==2?(or($.facets[0].scale,null,null),or($.facets[1].scale,null,null)):or($.scale,null,null),Xn())}),F!==!1&&Dn("setSeries",A,C),B&&Oa("setSeries",i,A,C)}i.setSeries=hs;function Rv(A,C){vn(T[A],C)}function Pv(A,C){A.fill=yt(A.fill||null),A.dir=Tt(A.dir,-1),C=C??T.length,T.splice(C,0,A)}function Iv(A){A==null?T.length=0:T.splice(A,1)}i.addBand=Pv,i.setBand=Rv,i.delBand=Iv;function Lv(A,C){m[A].alpha=C,le&&lt[A]!=null&&(lt[A].style.opacity=C),q&&Je[A]&&(Je[A].style.opacity=C)}let Ls,ar,Ir,Mo={focus:!0};function Nv(A){if(A!=Ir){let C=A==null,F=ze.alpha!=1;m.forEach((B,$)=>{if(s==1||$>0){let ee=C||$==0||$==A;B._focus=C?null:ee,F&&Lv($,ee?1:ze.alpha)}}),Ir=A,F&&Xn()}}q&&et&&St(fg,ge,A=>{K._lock||(Qe(A),Ir!=null&&hs(null,Mo,!0,xn.setSeries))});function fs(A,C,F){let B=b[C];F&&(A=A/Ct-(B.ori==1?at:je));let $=z;B.ori==1&&($=Ie,A=$-A),B.dir==-1&&(A=$-A);let ee=B._min,he=B._max,_e=A/$,Me=ee+(he-ee)*_e,Oe=B.distr;return Oe==3?Po(10,Me):Oe==4?Ab(Me,B.asinh):Oe==100?B.bwd(Me):Me}function Dv(A,C){let F=fs(A,M,C);return qi(F,e[0],un,hn)}i.valToIdx=A=>qi(A,e[0]),i.posToIdx=Dv,i.posToVal=fs,i.valToPos=(A,C,F)=>b[C].ori==0?r(A,b[C],F?J:z,F?O:0):o(A,b[C],F?me:Ie,F?E:0),i.setCursor=(A,C,F)=>{qt=A.left,tn=A.top,Lr(null,C,F)};function vm(A,C){Kt(So,Eo,Yt.left=A),Kt(So,Va,Yt.width=C)}function bm(A,C){Kt(So,"top",Yt.top=A),Kt(So,Ga,Yt.height=C)}let La=N.ori==0?vm:bm,Na=N.ori==1?vm:bm;function Ov(){if(q&&ue.live)for(let A=s==2?1:0;A<m.length;A++){if(A==0&&ct)continue;let C=ue.values[A],F=0;for(let B in C)Ge[A][F++].firstChild.nodeValue=C[B]}}function uf(A,C){if(A!=null&&(A.idxs?A.idxs.forEach((F,B)=>{te[B]=F}):Pb(A.idx)||te.fill(A.idx),ue.idx=te[0]),q&&ue.live){for(let F=0;F<m.length;F++)(F>0||s==1&&!ct)&&Fv(F,te[F]);Ov()}ye=!1,C!==!1&&Dn("setLegend")}i.setLegend=uf;function Fv(A,C){let F=m[A],B=A==0&&I==2?gi:e[A],$;ct?$=F.values(i,A,C)??rt:($=F.value(i,C==null?null:B[C],A,C),$=$==null?rt:{_:$}),ue.values[A]=$}function Lr(A,C,F){xm=qt,ym=tn,[qt,tn]=K.move(i,qt,tn),K.left=qt,K.top=tn,le&&(xo&&gs(xo,An(qt),0,z,Ie),yo&&gs(yo,0,An(tn),z,Ie));let B,$=un>hn;Ls=Vt,ar=null;let ee=N.ori==0?z:Ie,he=N.ori==1?z:Ie;if(qt<0||on==0||$){B=K.idx=null;for(let _e=0;_e<m.length;_e++){let Me=lt[_e];Me!=null&&gs(Me,-10,-10,z,Ie)}et&&hs(null,Mo,!0,A==null&&xn.setSeries),ue.live&&(te.fill(B),ye=!0)}else{let _e,Me,Oe;s==1&&(_e=N.ori==0?qt:tn,Me=fs(_e,M),B=K.idx=qi(Me,e[0],un,hn),Oe=U(e[0][B],N,ee,0));let Fe=-10,ke=-10,ot=0,At=0,wt=!0,_t="",Ze="";for(let $e=s==2?1:0;$e<m.length;$e++){let Jt=m[$e],ln=te[$e],On=ln==null?null:s==1?e[$e][ln]:e[$e][1][ln],Bt=K.dataIdx(i,$e,B,Me),cn=Bt==null?null:s==1?e[$e][Bt]:e[$e][1][Bt];if(ye=ye||cn!=On||Bt!=ln,te[$e]=Bt,$e>0&&Jt.show){let _i=Bt==null?-10:Bt==B?Oe:U(s==1?e[0][Bt]:e[$e][0][Bt],N,ee,0),si=cn==null?-10:D(cn,s==1?b[Jt.scale]:b[Jt.facets[1].scale],he,0);if(et&&cn!=null){let Li=N.ori==1?qt:tn,Wi=En(ze.dist(i,$e,Bt,si,Li));if(Wi<Ls){let ds=ze.bias;if(ds!=0){let xi=fs(Li,Jt.scale),Ni=cn>=0?1:-1,Xi=xi>=0?1:-1;Xi==Ni&&(Xi==1?ds==1?cn>=xi:cn<=xi:ds==1?cn<=xi:cn>=xi)&&(Ls=Wi,ar=$e)}else Ls=Wi,ar=$e}}if(ye||Pe){let Li,Wi;N.ori==0?(Li=_i,Wi=si):(Li=si,Wi=_i);let ds,xi,Ni,Xi,ps,ri,yi=!0,Nr=de.bbox;if(Nr!=null){yi=!1;let oi=Nr(i,$e);Ni=oi.left,Xi=oi.top,ds=oi.width,xi=oi.height}else Ni=Li,Xi=Wi,ds=xi=de.size(i,$e);if(ri=de.fill(i,$e),ps=de.stroke(i,$e),Pe)$e==ar&&Ls<=ze.prox&&(Fe=Ni,ke=Xi,ot=ds,At=xi,wt=yi,_t=ri,Ze=ps);else{let oi=lt[$e];oi!=null&&($t[$e]=Ni,ni[$e]=Xi,yg(oi,ds,xi,yi),_g(oi,ri,ps),gs(oi,Fi(Ni),Fi(Xi),z,Ie))}}}}if(Pe){let $e=ze.prox,Jt=Ir==null?Ls<=$e:Ls>$e||ar!=Ir;if(ye||Jt){let ln=lt[0];ln!=null&&($t[0]=Fe,ni[0]=ke,yg(ln,ot,At,wt),_g(ln,_t,Ze),gs(ln,Fi(Fe),Fi(ke),z,Ie))}}}if(Yt.show&&rr)if(A!=null){let[_e,Me]=xn.scales,[Oe,Fe]=xn.match,[ke,ot]=A.cursor.sync.scales,At=A.cursor.drag;if(Ln=At._x,Nn=At._y,Ln||Nn){let{left:wt,top:_t,width:Ze,height:$e}=A.select,Jt=A.scales[ke].ori,ln=A.posToVal,On,Bt,cn,_i,si,Li=_e!=null&&Oe(_e,ke),Wi=Me!=null&&Fe(Me,ot);Li&&Ln?(Jt==0?(On=wt,Bt=Ze):(On=_t,Bt=$e),cn=b[_e],_i=U(ln(On,ke),cn,ee,0),si=U(ln(On+Bt,ke),cn,ee,0),La(Yi(_i,si),En(si-_i))):La(0,ee),Wi&&Nn?(Jt==1?(On=wt,Bt=Ze):(On=_t,Bt=$e),cn=b[Me],_i=D(ln(On,ot),cn,he,0),si=D(ln(On+Bt,ot),cn,he,0),Na(Yi(_i,si),En(si-_i))):Na(0,he)}else df()}else{let _e=En(xm-gm),Me=En(ym-_m);if(N.ori==1){let ot=_e;_e=Me,Me=ot}Ln=zn.x&&_e>=zn.dist,Nn=zn.y&&Me>=zn.dist;let Oe=zn.uni;Oe!=null?Ln&&Nn&&(Ln=_e>=Oe,Nn=Me>=Oe,!Ln&&!Nn&&(Me>_e?Nn=!0:Ln=!0)):zn.x&&zn.y&&(Ln||Nn)&&(Ln=Nn=!0);let Fe,ke;Ln&&(N.ori==0?(Fe=vo,ke=qt):(Fe=bo,ke=tn),La(Yi(Fe,ke),En(ke-Fe)),Nn||Na(0,he)),Nn&&(N.ori==1?(Fe=vo,ke=qt):(Fe=bo,ke=tn),Na(Yi(Fe,ke),En(ke-Fe)),Ln||La(0,ee)),!Ln&&!Nn&&(La(0,0),Na(0,0))}if(zn._x=Ln,zn._y=Nn,A==null){if(F){if(Lm!=null){let[_e,Me]=xn.scales;xn.values[0]=_e!=null?fs(N.ori==0?qt:tn,_e):null,xn.values[1]=Me!=null?fs(N.ori==1?qt:tn,Me):null}Oa(If,i,qt,tn,z,Ie,B)}if(et){let _e=F&&xn.setSeries,Me=ze.prox;Ir==null?Ls<=Me&&hs(ar,Mo,!0,_e):Ls>Me?hs(null,Mo,!0,_e):ar!=Ir&&hs(ar,Mo,!0,_e)}}ye&&(ue.idx=B,uf()),C!==!1&&Dn("setCursor")}let lr=null;Object.defineProperty(i,"rect",{get(){return lr==null&&Da(!1),lr}});function Da(A=!1){A?lr=null:(lr=y.getBoundingClientRect(),Dn("syncRect",lr))}function Sm(A,C,F,B,$,ee,he){K._lock||rr&&A!=null&&A.movementX==0&&A.movementY==0||(hf(A,C,F,B,$,ee,he,!1,A!=null),A!=null?Lr(null,!0,!0):Lr(C,!0,!1))}function hf(A,C,F,B,$,ee,he,_e,Me){if(lr==null&&Da(!1),Qe(A),A!=null)F=A.clientX-lr.left,B=A.clientY-lr.top;else{if(F<0||B<0){qt=-10,tn=-10;return}let[Oe,Fe]=xn.scales,ke=C.cursor.sync,[ot,At]=ke.values,[wt,_t]=ke.scales,[Ze,$e]=xn.match,Jt=C.axes[0].side%2==1,ln=N.ori==0?z:Ie,On=N.ori==1?z:Ie,Bt=Jt?ee:$,cn=Jt?$:ee,_i=Jt?B:F,si=Jt?F:B;if(wt!=null?F=Ze(Oe,wt)?a(ot,b[Oe],ln,0):-10:F=ln*(_i/Bt),_t!=null?B=$e(Fe,_t)?a(At,b[Fe],On,0):-10:B=On*(si/cn),N.ori==1){let Li=F;F=B,B=Li}}Me&&(C==null||C.cursor.event.type==If)&&((F<=1||F>=z-1)&&(F=Ur(F,z)),(B<=1||B>=Ie-1)&&(B=Ur(B,Ie))),_e?(gm=F,_m=B,[vo,bo]=K.move(i,F,B)):(qt=F,tn=B)}let ff={width:0,height:0,left:0,top:0};function df(){Kl(ff,!1)}let Mm,wm,Tm,Am;function Em(A,C,F,B,$,ee,he){rr=!0,Ln=Nn=zn._x=zn._y=!1,hf(A,C,F,B,$,ee,he,!0,!1),A!=null&&(St(Lf,Uf,Cm,!1),Oa(ug,i,vo,bo,z,Ie,null));let{left:_e,top:Me,width:Oe,height:Fe}=Yt;Mm=_e,wm=Me,Tm=Oe,Am=Fe}function Cm(A,C,F,B,$,ee,he){rr=zn._x=zn._y=!1,hf(A,C,F,B,$,ee,he,!1,!0);let{left:_e,top:Me,width:Oe,height:Fe}=Yt,ke=Oe>0||Fe>0,ot=Mm!=_e||wm!=Me||Tm!=Oe||Am!=Fe;if(ke&&ot&&Kl(Yt),zn.setScale&&ke&&ot){let At=_e,wt=Oe,_t=Me,Ze=Fe;if(N.ori==1&&(At=Me,wt=Fe,_t=_e,Ze=Oe),Ln&&or(M,fs(At,M),fs(At+wt,M)),Nn)for(let $e in b){let Jt=b[$e];$e!=M&&Jt.from==null&&Jt.min!=Vt&&or($e,fs(_t+Ze,$e),fs(_t,$e))}df()}else K.lock&&(K._lock=!K._lock,Lr(C,!0,A!=null));A!=null&&(wn(Lf,Uf),Oa(Lf,i,qt,tn,z,Ie,null))}function Uv(A,C,F,B,$,ee,he){if(K._lock)return;Qe(A);let _e=rr;if(rr){let Me=!0,Oe=!0,Fe=10,ke,ot;N.ori==0?(ke=Ln,ot=Nn):(ke=Nn,ot=Ln),ke&&ot&&(Me=qt<=Fe||qt>=z-Fe,Oe=tn<=Fe||tn>=Ie-Fe),ke&&Me&&(qt=qt<vo?0:z),ot&&Oe&&(tn=tn<bo?0:Ie),Lr(null,!0,!0),rr=!1}qt=-10,tn=-10,te.fill(null),Lr(null,!0,!0),_e&&(rr=_e)}function Rm(A,C,F,B,$,ee,he){K._lock||(Qe(A),Ia(),df(),A!=null&&Oa(dg,i,qt,tn,z,Ie,null))}function Pm(){S.forEach($S),k(i.width,i.height,!0)}zr(vc,Ro,Pm);let wo={};wo.mousedown=Em,wo.mousemove=Sm,wo.mouseup=Cm,wo.dblclick=Rm,wo.setSeries=(A,C,F,B)=>{let $=xn.match[2];F=$(i,C,F),F!=-1&&hs(F,B,!0,!1)},le&&(St(ug,y,Em),St(If,y,Sm),St(hg,y,A=>{Qe(A),Da(!1)}),St(fg,y,Uv),St(dg,y,Rm),Xf.add(i),i.syncRect=Da);let Ql=i.hooks=n.hooks||{};function Dn(A,C,F){ii?Dt.push([A,C,F]):A in Ql&&Ql[A].forEach(B=>{B.call(null,i,C,F)})}(n.plugins||[]).forEach(A=>{for(let C in A.hooks)Ql[C]=(Ql[C]||[]).concat(A.hooks[C])});let Im=(A,C,F)=>F,xn=vn({key:null,setSeries:!1,filters:{pub:wg,sub:wg},scales:[M,m[1]?m[1].scale:null],match:[Tg,Tg,Im],values:[null,null]},K.sync);xn.match.length==2&&xn.match.push(Im),K.sync=xn;let Lm=xn.key,pf=b0(Lm);function Oa(A,C,F,B,$,ee,he){xn.filters.pub(A,C,F,B,$,ee,he)&&pf.pub(A,C,F,B,$,ee,he)}pf.sub(i);function Bv(A,C,F,B,$,ee,he){xn.filters.sub(A,C,F,B,$,ee,he)&&wo[A](null,C,F,B,$,ee,he)}i.pub=Bv;function kv(){pf.unsub(i),Xf.delete(i),In.clear(),zf(vc,Ro,Pm),c.remove(),ge?.remove(),Dn("destroy")}i.destroy=kv;function mf(){Dn("init",n,e),Pa(e||n.data,!1),V[M]?af(M,V[M]):Ia(),re=Yt.show&&(Yt.width>0||Yt.height>0),ie=ye=!0,k(n.width,n.height)}return m.forEach(po),S.forEach(Cs),t?t instanceof HTMLElement?(t.appendChild(c),mf()):t(i,mf):mf(),i}Fn.assign=vn;Fn.fmtNum=Kf;Fn.rangeNum=bc;Fn.rangeLog=wc;Fn.rangeAsinh=jf;Fn.orient=Gr;Fn.pxRatio=Ct;Fn.join=Ub;Fn.fmtDate=ed,Fn.tzDate=Yb;Fn.sync=b0;{Fn.addGap=PS,Fn.clipGaps=Ec;let n=Fn.paths={points:E0};n.linear=R0,n.stepped=NS,n.bars=DS,n.spline=FS}var qS=Symbol.for("pv"),YS=0;function x(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:qS,__v:--YS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Ot.vnode&&Ot.vnode(c),c}var Gn=({tone:n,children:e})=>x("span",{class:`badge ${n}`,children:e}),JS={queued:"wait",running:"wait",succeeded:"good",failed:"bad",dead:"bad",expired:"bad",cancelled:"neutral"},Uo=({state:n})=>x(Gn,{tone:JS[n],children:n}),Ji=({share:n,label:e})=>x("progress",{class:"bar",max:1,value:n,"aria-label":e});function Ht({text:n}){return n===null?null:x("p",{class:"failure",role:"alert",children:n})}function Jn({rows:n}){return x("dl",{class:"facts",children:n.map(([e,t])=>x("div",{children:[x("dt",{children:e}),x("dd",{children:t})]},e))})}function Ui(){let[n,e]=pe(Date.now());return mt(()=>{let t=setInterval(()=>e(Date.now()),1e3);return()=>clearInterval(t)},[]),n}function Bo(n,e){let[t,i]=pe(localStorage.getItem(`homolog-${n}`)??e);return[t,s=>{i(s),localStorage.setItem(`homolog-${n}`,s)}]}function sn(n,e){mt(()=>{let t=new AbortController;return n(t.signal),()=>t.abort()},e)}function Hr(){let[n,e]=pe(0);return mt(()=>{let t=()=>e(s=>s+1),i=matchMedia("(prefers-color-scheme: dark)");return i.addEventListener("change",t),window.addEventListener("theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("theme",t)}},[]),n}function ko(n){let e=Xt(null),t=Xt(null),i=Xt(n.marks);i.current=n.marks;let s=Hr(),r=JSON.stringify([s,n.log,n.series.map(({label:a,color:l,scale:c})=>[a,l,c]),n.height]),o=[n.x,...n.series.map(a=>a.values)];return mt(()=>{let a=e.current,{color:l,borderTopColor:c}=getComputedStyle(a),u={stroke:l,grid:{stroke:c,width:1},ticks:{stroke:c,width:1},font:"12px system-ui",labelFont:"12px system-ui",labelSize:18},h=n.series.some(y=>y.scale==="right"),f=new Fn({width:a.clientWidth||300,height:n.height,scales:{x:{time:!1},y:{distr:n.log?3:1},right:{}},axes:[{...u,label:n.xLabel},{...u,label:n.yLabel,size:58},...h?[{...u,label:n.rightLabel,scale:"right",side:1,size:50,grid:{show:!1}}]:[]],series:[{label:n.xLabel},...n.series.map(({label:y,color:v,dash:g,width:_,scale:m,points:S})=>({label:y,stroke:v,width:_??1.5,dash:g,scale:m??"y",spanGaps:!0,points:{show:S??!1,size:5},fill:n.bars?v:void 0,paths:n.bars?Fn.paths.bars({size:[.9]}):S?()=>null:void 0,value:(b,T)=>T==null?"–":T.toPrecision(4)}))],legend:{live:!n.bars},hooks:{draw:[y=>{let{ctx:v}=y;v.save(),v.strokeStyle=c,v.fillStyle=l,v.font=`${12*devicePixelRatio}px system-ui`;for(let{at:g,text:_}of i.current??[]){let m=y.valToPos(g,"x",!0);v.beginPath(),v.moveTo(m,y.bbox.top),v.lineTo(m,y.bbox.top+y.bbox.height),v.stroke(),v.fillText(_,m+4*devicePixelRatio,y.bbox.top+12*devicePixelRatio)}v.restore()}]}},o,a);t.current=f;let d=new ResizeObserver(()=>f.setSize({width:a.clientWidth,height:n.height}));return d.observe(a),()=>{d.disconnect(),f.destroy()}},[r]),mt(()=>t.current?.setData(o)),x("div",{class:"plot",ref:e,role:"img","aria-label":n.title,"data-points":n.x.length})}function qa({value:n,take:e,...t}){let[i,s]=pe(null);return x("input",{...t,value:i??n,onInput:r=>s(r.currentTarget.value),onChange:r=>{s(null),e(r.currentTarget.value)}})}function Ti({label:n,checked:e,onChange:t}){return x("label",{class:"check",children:[x("input",{type:"checkbox",checked:e,onChange:t})," ",n]})}function N0(){let[n="",e=""]=location.hash.replace(/^#\/?/,"").split("?");return{path:n.split("/").filter(Boolean).map(decodeURIComponent),query:new URLSearchParams(e)}}function ji(n,e={},t=!1){let i=Object.entries(e).filter(([,o])=>o!==""),s=new URLSearchParams(i).toString(),r=`#/${n}${s===""?"":`?${s}`}`;t?(history.replaceState(null,"",r),window.dispatchEvent(new HashChangeEvent("hashchange"))):location.hash=r}function D0(){let[n,e]=pe(N0);return mt(()=>{let t=()=>e(N0());return window.addEventListener("hashchange",t),()=>window.removeEventListener("hashchange",t)},[]),n}var Ic=["state","method","label","external_ref","batch","study","order"];function jS(n){try{let e=JSON.parse(n);return Array.isArray(e)?e.filter(t=>typeof t?.name=="string"&&typeof t.filters=="object"&&t.filters!==null):[]}catch{return[]}}var ZS=(n,e)=>Ic.every(t=>(n[t]??"")===(e[t]??""));function O0({filters:n,isFiltered:e}){let[t,i]=Bo("filters","[]"),[s,r]=pe(null),o=jS(t),a=o.find(c=>ZS(c.filters,n)),l=()=>{let c=(s??"").trim();c!==""&&i(JSON.stringify([...o.filter(u=>u.name!==c),{name:c,filters:n}])),r(null)};return x(Et,{children:[o.length>0&&x("label",{children:["Saved filters"," ",x("select",{value:a?.name??"",onChange:c=>ji("jobs",o.find(u=>u.name===c.currentTarget.value)?.filters??{},!0),children:[x("option",{value:"",children:"none"}),o.map(c=>x("option",{value:c.name,children:c.name}))]})]}),a?x("button",{type:"button",onClick:()=>i(JSON.stringify(o.filter(c=>c!==a))),children:["Forget “",a.name,"”"]}):e&&(s===null?x("button",{type:"button",onClick:()=>r(""),children:"Save these filters …"}):x("span",{class:"group",children:[x("input",{"aria-label":"Name of these filters",placeholder:"name",value:s,onInput:c=>r(c.currentTarget.value),onKeyDown:c=>{c.key==="Enter"?l():c.key==="Escape"&&r(null)}}),x("button",{type:"button",onClick:l,children:"Save"})]}))]})}function F0(n){return typeof n=="object"?n.key:n}function U0(n,e){let t=n.length;return new Proxy(n,{get(i,s,r){if(typeof s=="string"){let o=s.charCodeAt(0);if(o>=48&&o<=57){let a=+s;if(Number.isInteger(a)&&a>=0&&a<t){let l=i[a];if(typeof l!="object"){let c=e[a*2];l=i[a]={index:a,key:l,start:c,size:e[a*2+1],end:c+e[a*2+1],lane:0}}return l}}if(s==="length")return t}return Reflect.get(i,s,r)}})}function Wr(n,e,t){let i=t.initialDeps??[],s,r=!0;function o(){var a;let c=0,u=n();if(!(u.length!==i.length||u.some((d,y)=>i[y]!==d)))return s;i=u;let f=0;return s=e(...u),t?.onChange&&!(r&&t.skipInitialOnChange)&&t.onChange(s),r=!1,s}return o.updateDeps=a=>{i=a},o}function ad(n,e){if(n===void 0)throw new Error(`Unexpected undefined${e?`: ${e}`:""}`);return n}var Os=(n,e)=>Math.abs(n-e)<1.01,B0=(n,e,t)=>{let i;return Object.assign(function(...s){n.clearTimeout(i),i=n.setTimeout(()=>e.apply(this,s),t)},{cancel:()=>{n.clearTimeout(i)}})};function k0({offset:n,isScrolling:e,elementMax:t,holdOffset:i,scrollOffset:s,pendingWrite:r,clampedMaxAtWrite:o}){var a;return e&&r===null&&n===s?"spurious":r!==null&&Math.abs(n-r.target)<1.5?"readBack":r!==null&&!r.smooth&&t!==null&&r.target>t+i+.5&&Math.abs(n-(t+i))<1.5||r!==null&&!r.smooth&&((a=r.lowMaxes)!=null&&a.some(l=>Math.abs(n-l)<1.5))?"clampedReadBack":o!==null&&Math.abs(n-o)<1.5?"clampedEcho":"external"}var KS=n=>n==="smooth"||n==="smoothFinishing";function z0({kind:n,offset:e,command:t,target:i}){return n!=="spurious"&&n!=="readBack"&&n!=="clampedReadBack"&&t?.index!=null&&t.phase!=="queued"&&!KS(t.phase)&&!Os(e,t.lastTargetOffset)&&!Os(e,i())&&n!=="clampedEcho"}var ld=40;function V0(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<ld;)t--;if(t<0)return!1;let i=n[t],s=t-1;for(;s>=0&&i.t-n[s].t<ld;)s--;if(s<0)return!1;let r=n[s],o=(e.offset-i.offset)/(e.t-i.t),a=(i.offset-r.offset)/(i.t-r.t);return o*a>=0&&Math.abs(o)>=2*Math.abs(a)&&Math.abs(o)-Math.abs(a)>=.8}function G0(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<ld;)t--;if(t<0)return!1;let i=n[t];return Math.abs(e.offset-i.offset)/(e.t-i.t)>=.05}var Ya,Ja=()=>{if(Ya!==void 0)return Ya;if(typeof navigator>"u")return Ya=!1;if(/iP(hone|od|ad)/.test(navigator.userAgent))return Ya=!0;let n=navigator.maxTouchPoints;return Ya=navigator.platform==="MacIntel"&&n!==void 0&&n>0},cd,QS=()=>cd!==void 0?cd:cd=Ja()&&typeof CSS<"u"&&typeof CSS.supports=="function"&&CSS.supports("overflow-anchor: auto"),H0=()=>!Ja()||QS();var zo={capture:!0,passive:!0},Lc=class{constructor(e){this.host=e,this._touch=null,this.inMotion=()=>this._touch!==null&&this._touch.phase!=="lateFling",this.dragging=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved},this.tail=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="tail"?this._touch.moved?"fling":"tap":null},this.onScroll=({isScrolling:t,ownReadBack:i,moved:s,external:r})=>{var o,a,l;return t&&((o=this._touch)==null?void 0:o.phase)==="tail"?this._openTail(this._touch.moved||!i,!1):((a=this._touch)==null?void 0:a.phase)==="lateFling"&&(this.host.now()>this._touch.until?this._touch=null:r&&t&&s&&this._openTail(!0,!1)),!i&&t&&s&&((l=this._touch)==null?void 0:l.phase)==="down"?(this._touch.moved=!0,!0):!1},this.touchStart=()=>{this.end(),this._touch={phase:"down",moved:!1}},this.touchEnd=()=>{var t;let i=((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved;this.end(),this._openTail(i,i)},this.end=()=>{var t;let i=this.host.getWindow();((t=this._touch)==null?void 0:t.phase)==="tail"&&i!=null&&i.clearTimeout(this._touch.timerId),this._touch=null},this.listen=t=>{let i=()=>this.touchStart(),s=()=>this.touchEnd();return t.addEventListener("touchstart",i,zo),t.addEventListener("touchend",s,zo),t.addEventListener("touchcancel",s,zo),()=>{t.removeEventListener("touchstart",i,zo),t.removeEventListener("touchend",s,zo),t.removeEventListener("touchcancel",s,zo),this.end()}},this._openTail=(t,i)=>{let s=this.host.getWindow();if(s==null)return;this.end();let r={phase:"tail",moved:t,awaitingFling:i,timerId:s.setTimeout(()=>{if(this.host.tailStillMoving()){this._openTail(r.moved,r.awaitingFling);return}this._touch=r.awaitingFling?{phase:"lateFling",until:this.host.now()+1e3}:null,this.host.onTailClosed()},150)};this._touch=r}}get touch(){return this._touch}};var W0=n=>{let{clientWidth:e,clientHeight:t}=n;return{width:e,height:t}},q0=n=>{let e=new Set;return{schedule:t=>{let i=n.requestAnimationFrame(()=>{e.delete(i),t()});e.add(i)},cancel:()=>{e.forEach(t=>n.cancelAnimationFrame(t)),e.clear()}}},eM=n=>n,tM=n=>{let e=n.overscan*Math.max(n.lanes??1,1),t=Math.max(n.startIndex-e,0),s=Math.min(n.endIndex+e,n.count-1)-t+1,r=new Array(s);for(let o=0;o<s;o++)r[o]=t+o;return r},Y0=(n,e)=>{let t=n.scrollElement;if(!t)return;let i=n.targetWindow;if(!i)return;let s=a=>{let{width:l,height:c}=a;e({width:Math.round(l),height:Math.round(c)})};if(s(W0(t)),!i.ResizeObserver)return()=>{};let r=q0(i),o=new i.ResizeObserver(()=>{let a=()=>{s(W0(t))};n.options.useAnimationFrameWithResizeObserver?r.schedule(a):a()});return o.observe(t,{box:"content-box"}),()=>{o.unobserve(t),r.cancel()}},X0={passive:!0};var nM=typeof window>"u"?!0:"onscrollend"in window,iM=(n,e,t)=>{let i=n.scrollElement;if(!i)return;let s=n.targetWindow;if(!s)return;let r=n.options.useScrollendEvent&&nM,o=0,a=r?null:B0(s,()=>e(t(i),!1),n.options.isScrollingResetDelay),l=h=>()=>{o=t(i),a?.(),e(o,h)},c=l(!0),u=l(!1);return i.addEventListener("scroll",c,X0),r&&i.addEventListener("scrollend",u,X0),()=>{i.removeEventListener("scroll",c),r&&i.removeEventListener("scrollend",u),a?.cancel()}},J0=(n,e)=>iM(n,e,t=>{let{horizontal:i,isRtl:s}=n.options;return i?t.scrollLeft*(s&&-1||1):t.scrollTop});var sM=(n,e,t)=>{if(t.options.useCachedMeasurements){let i=t.indexFromElement(n),s=t.options.getItemKey(i);return t.itemSizeCache.get(s)??t.options.estimateSize(i)}if(e?.borderBoxSize){let i=e.borderBoxSize[0];if(i)return Math.round(i[t.options.horizontal?"inlineSize":"blockSize"])}if(!e){let i=t.indexFromElement(n),s=t.options.getItemKey(i),r=t.itemSizeCache.get(s);if(r!==void 0)return r}return n[t.options.horizontal?"offsetWidth":"offsetHeight"]},rM=(n,{adjustments:e=0,behavior:t},i)=>{var s;let{scrollElement:r,options:o}=i,a=n+e,l=o.horizontal&&o.isRtl&&r!==null&&"ownerDocument"in r;(s=r?.scrollTo)==null||s.call(r,{[o.horizontal?"left":"top"]:l?-a:a,behavior:t})};var j0=rM,$0=(n,e)=>n==="smooth"?e?"smoothLanded":"smooth":"instant",ja=n=>n?.phase==="smooth"||n?.phase==="smoothLanded";function oM(n,e,t,i){if(e===0)return!1;let s=i(0),r=new Set,o=0;for(;o<n;){let l=t(o);if(l===s)break;r.add(l),o++}let a=n-o;if(a===0||a>=e)return!1;for(let l=0;l<a;l++)if(i(l)!==t(o+l))return!1;for(let l=a;l<e;l++)if(r.has(i(l)))return!1;return!0}var Nc=class{constructor(e){this.unsubs=[],this.scrollElement=null,this.targetWindow=null,this.isScrolling=!1,this.scrollState=null,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache=new Map,this.itemSizeCacheVersion=0,this.laneAssignments=new Map,this.pendingMin=null,this.prevLanes=void 0,this.lanesChangedFlag=!1,this.lanesSettling=!1,this.pendingScrollAnchor=null,this.scrollRect=null,this.scrollOffset=null,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._iosGesture=new Lc({getWindow:()=>this.targetWindow,now:()=>this.now(),tailStillMoving:()=>{let t=this.scrollState;if(t?.phase!=="queued"||this.pendingWrite!==null)return!1;let i=this._readElementOffset();return i===null||this._lastElementOffset===null||Math.abs(i-this._lastElementOffset)<1?!1:(this._lastElementOffset=i,t.samples=[...t.samples??[],{t:this.now(),offset:i}],!0)},onTailClosed:()=>{let t=this.scrollState;t?.phase==="queued"&&G0(t.samples??[])&&(this.scrollState=null),this._flushHoldIfReady(!0),this._writeAwaitingCommand(),this._retryClampedAdjustment()}}),this._lastElementOffset=null,this.pendingWrite=null,this._clampedAdjustment=null,this.elementsCache=new Map,this._resizeBatch=null,this.now=()=>{var t,i,s;return((s=(i=(t=this.targetWindow)==null?void 0:t.performance)==null?void 0:i.now)==null?void 0:s.call(i))??Date.now()},this.observer=(()=>{let t=null,i=null,s=!1,r=!1,o=new Set,a=()=>{if(t)return t;let c=this.targetWindow;if(!c||!c.ResizeObserver)return null;let u=i=q0(c);return t=new c.ResizeObserver(h=>{let f=()=>{let d={sync:!1};this._resizeBatch=d;try{h.forEach(l)}finally{this._resizeBatch=null,d.notify&&(this.notify(d.sync),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment(),this.measureElement(null))}};if(this.options.useAnimationFrameWithResizeObserver)u.schedule(f);else{s=!0;try{f()}finally{s=!1}}})},l=c=>{let u=c.target,h=this.indexFromElement(u);if(!u.isConnected){this.observer.unobserve(u);for(let[f,d]of this.elementsCache)if(d===u){this.elementsCache.delete(f);break}return}this.isIndexInRange(h)&&this.shouldMeasureDuringScroll(h)&&this.resizeItem(h,this.options.measureElement(u,c,this))};return{disconnect:()=>{var c;(c=a())==null||c.disconnect(),i?.cancel(),o.clear(),r=!1,t=null,i=null},observe:c=>{let u=a();if(u){if(!s){u.observe(c,{box:"border-box"});return}o.add(c),r||(r=!0,i?.schedule(()=>{r=!1,o.forEach(h=>{h.isConnected&&t?.observe(h,{box:"border-box"})}),o.clear()}))}},unobserve:c=>{var u;o.delete(c),(u=a())==null||u.unobserve(c)}}})(),this.range=null,this.setOptions=t=>{var i;let s={debug:!1,initialOffset:0,overscan:1,paddingStart:0,paddingEnd:0,scrollPaddingStart:0,scrollPaddingEnd:0,horizontal:!1,getItemKey:eM,rangeExtractor:tM,onChange:()=>{},measureElement:sM,initialRect:{width:0,height:0},scrollMargin:0,gap:0,indexAttribute:"data-index",initialMeasurementsCache:[],lanes:1,anchorTo:"start",followOnAppend:!1,scrollEndThreshold:1,isScrollingResetDelay:150,enabled:!0,isRtl:!1,useScrollendEvent:!1,useAnimationFrameWithResizeObserver:!1,laneAssignmentMode:"estimate",useCachedMeasurements:!1};for(let u in t){let h=t[u];h!==void 0&&(s[u]=h)}let r=this.options,o=null,a=null,l=!1;if(r!==void 0&&r.enabled&&s.enabled&&s.anchorTo==="end"&&this.scrollElement!==null){let u=r.count,h=s.count,f=this.getMeasurements(),d=((i=this._singleLaneMeasurements)==null?void 0:i.items)??f,y=S=>F0(d[S]),v=u>0?y(0):null,g=u>0?y(u-1):null;if(h!==u||u>0&&h>0&&(s.getItemKey(0)!==v||s.getItemKey(h-1)!==g)){l=!0;let S=u>0?this.getVirtualItemForOffset(this.getScrollOffset())??f[0]:null;S&&(o=[S.key,this.getScrollOffset()-S.start]);let b=s.followOnAppend===!0?"auto":s.followOnAppend||null;b&&h>0&&this.isAtEnd(r.scrollEndThreshold)&&(u===0||s.getItemKey(h-1)!==g)&&(h>u||oM(u,h,y,s.getItemKey))&&(a=b)}}this.options=s,l&&(this.pendingMin=0,this.itemSizeCacheVersion++);let c=null;if(o&&this.scrollOffset!==null&&!this._awaitingCommandReadBack()){let[u,h]=o,f=this.getMeasurements(),{count:d,getItemKey:y}=this.options,v=0;for(;v<d&&y(v)!==u;)v++;if(v<d){let g=f[v];if(g){let _=Math.max(0,g.start+h);!a&&_!==this.scrollOffset&&(c=_-this.scrollOffset,this.scrollOffset=_)}}}a?this.pendingScrollAnchor={kind:"follow",behavior:a}:c!==null&&(this._canWriteScroll()?this.pendingScrollAnchor={kind:"anchor",delta:c}:(this._holdOffset+=c,this._followOffsetTarget(c)))},this.notify=t=>{var i,s;(s=(i=this.options).onChange)==null||s.call(i,this,t)},this.maybeNotify=Wr(()=>(this.calculateRange(),[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]),t=>{this.notify(t)},{key:!1,debug:()=>this.options.debug,initialDeps:[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]}),this.cleanup=()=>{var t;this.unsubs.filter(Boolean).forEach(i=>i()),this.unsubs=[],this.observer.disconnect(),this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null,(t=this._momentumStop)==null||t.restore(),this._momentumStop=null,this.isScrolling=!1,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._clampedAdjustment=null,this.pendingWrite=null,this.scrollElement=null,this.targetWindow=null},this._didMount=()=>()=>{this.cleanup()},this._willUpdate=()=>{var t;let i=this.options.enabled?this.options.getScrollElement():null;if(this.scrollElement!==i){if(this.cleanup(),!i){this.maybeNotify();return}this.scrollElement=i,this.scrollElement&&"ownerDocument"in this.scrollElement?this.targetWindow=this.scrollElement.ownerDocument.defaultView:this.targetWindow=((t=this.scrollElement)==null?void 0:t.window)??null,this.elementsCache.forEach(r=>{this.observer.observe(r)}),this.unsubs.push(this.options.observeElementRect(this,r=>{this.scrollRect=r,this.maybeNotify()})),this.unsubs.push(this.options.observeElementOffset(this,(r,o)=>{var a,l,c,u;let h=o?this._elementMaxScrollOffset():null,f=this._reportedOverscroll;this._reportedOverscroll=r<0||h!==null&&r>h+1;let d=r;this._lastElementOffset=d,r=this._toLayoutOffset(r);let y=this._classifyScrollEvent(r,o,h);if(y==="spurious")return;y==="readBack"?r=this.pendingWrite.target:y==="clampedReadBack"&&((a=this.scrollState)==null?void 0:a.index)!=null&&r<this.getMaxScrollOffset()-1.5?this.scrollState.lastTargetOffset=r:z0({kind:y,offset:r,command:this.scrollState,target:()=>this.getScrollStateTarget(this.scrollState)})&&(this.scrollState=null),this.pendingWrite=null,this._clampedAdjustment!==null&&Math.abs(r-this._clampedAdjustment.maxAtWrite)>=1.5&&(this._clampedAdjustment=null);let v=this.getScrollOffset(),g=this.scrollDirection;this.scrollDirection=o?v===r?this.scrollDirection:v<r?"forward":"backward":null,this.scrollOffset=r,this.isScrolling=o;let _=this.scrollState;if(_?.phase==="queued"&&y==="external"&&o)if(f||this._reportedOverscroll)_.samples=[];else{let m=this.now();_.samples=[...(_.samples??[]).filter(S=>m-S.t<=200),{t:m,offset:d}],(g!==null&&this.scrollDirection!==g||V0(_.samples))&&(this.scrollState=null)}this._iosGesture.onScroll({isScrolling:o,ownReadBack:y==="readBack",moved:r!==v,external:y==="external"&&((l=this.scrollState)==null?void 0:l.phase)!=="smooth"&&((c=this.scrollState)==null?void 0:c.phase)!=="smoothFinishing"})&&((u=this.scrollState)==null?void 0:u.phase)==="queued"&&(this.scrollState=null),this._flushHoldIfReady(!0),this.scrollState&&this.scheduleScrollReconcile(),this.maybeNotify()})),"addEventListener"in this.scrollElement&&this.unsubs.push(this._iosGesture.listen(this.scrollElement)),this._scrollToOffset(this.getScrollOffset())}this._noteClampMax();let s=this.pendingScrollAnchor;this.pendingScrollAnchor=null,s&&this.scrollElement&&this.options.enabled&&(s.kind==="anchor"?this._canWriteScroll()?ja(this.scrollState)&&!Os(this.getScrollOffset()-s.delta,this.scrollState.lastTargetOffset)||(this._followOffsetTarget(s.delta),this._scrollToOffset(this.getScrollOffset())):(this._holdOffset+=s.delta,this._followOffsetTarget(s.delta),this.notify(!1)):this.scrollToEnd({behavior:s.behavior})),this._flushHoldIfReady(!1),this._retryClampedAdjustment()},this._classifyScrollEvent=(t,i,s)=>{var r;return k0({offset:t,isScrolling:i,elementMax:s,holdOffset:this._holdOffset,scrollOffset:this.scrollOffset,pendingWrite:this.pendingWrite,clampedMaxAtWrite:((r=this._clampedAdjustment)==null?void 0:r.maxAtWrite)??null})},this._retryClampedAdjustment=()=>{if(this._clampedAdjustment===null||!this.scrollElement||!this.options.enabled||!this._canWriteScroll())return;let{target:t,maxAtWrite:i}=this._clampedAdjustment,s=this.getMaxScrollOffset();s>i+.5&&(this._clampedAdjustment=t>s+.5?{target:t,maxAtWrite:s}:null,this._scrollToOffset(t))},this._writeAwaitingCommand=()=>{let t=this.scrollState;if(t===null||t.phase!=="queued")return;let{behavior:i}=t;this.getMeasurements();let s=this.getScrollStateTarget(t);t.lastTargetOffset=s,this._clampedAdjustment=null,t.phase=$0(i,t.index!=null&&Os(s,this.getScrollOffset())),this._scrollToOffset(s,{behavior:i}),this.scheduleScrollReconcile()},this._readElementOffset=()=>{let t=this.scrollElement;if(t==null)return null;let{horizontal:i,isRtl:s}=this.options;return typeof t.scrollTop=="number"?i?t.scrollLeft*(s&&-1||1):t.scrollTop:typeof t.scrollY=="number"?i?t.scrollX:t.scrollY:null},this._canWriteScroll=()=>!(Ja()&&this._iosGesture.inMotion())&&!this._reportedOverscroll,this._flushHoldIfReady=t=>{var i;if(this._holdOffset===0||!this.scrollElement||!this.options.enabled||!this._canWriteScroll()||((i=this.scrollState)==null?void 0:i.phase)==="smooth")return;this._holdOffset=0,this.scrollOffset!==null&&this.scrollOffset<0&&(this.scrollOffset=0),this.notify(t);let s=this.getCommandWrittenOffset()??this.getScrollOffset();this._clampedAdjustment=this._clampedBy(s),this._scrollToOffset(s)},this.rafId=null,this.getSize=()=>this.options.enabled?(this.scrollRect=this.scrollRect??this.options.initialRect,this.scrollRect[this.options.horizontal?"width":"height"]):(this.scrollRect=null,0),this.getScrollOffset=()=>this.options.enabled?(this.scrollOffset=this.scrollOffset??(typeof this.options.initialOffset=="function"?this.options.initialOffset():this.options.initialOffset),this.scrollOffset):(this.scrollOffset=null,0),this.getMeasurementOptions=Wr(()=>[this.options.count,this.options.paddingStart,this.options.scrollMargin,this.options.getItemKey,this.options.enabled,this.options.lanes,this.options.laneAssignmentMode,this.options.gap],(t,i,s,r,o,a,l,c)=>(this.prevLanes!==void 0&&this.prevLanes!==a&&(this.lanesChangedFlag=!0),this.prevLanes=a,this.pendingMin=null,{count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c}),{key:!1}),this.isIndexInRange=t=>t>=0&&t<this.options.count,this.getMeasurements=Wr(()=>[this.getMeasurementOptions(),this.itemSizeCacheVersion],({count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c},u)=>{var h;let f=this.itemSizeCache;if(!o)return this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),[];if(this.laneAssignments.size>t)for(let m of this.laneAssignments.keys())m>=t&&this.laneAssignments.delete(m);this.lanesChangedFlag&&(this.lanesChangedFlag=!1,this.lanesSettling=!0,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.pendingMin=null),this.measurementsCache.length===0&&!this.lanesSettling&&(this.measurementsCache=this.options.initialMeasurementsCache,this.measurementsCache.forEach(m=>{this.itemSizeCache.set(m.key,m.size)}));let d=this.lanesSettling?0:this.pendingMin??0;if(this.pendingMin=null,this.lanesSettling&&this.measurementsCache.length===t&&(this.lanesSettling=!1),a===1){let m=t*2,S=(h=this._singleLaneMeasurements)==null?void 0:h.flat;if(!S||S.length<m){let p=new Float64Array(m);S&&d>0&&p.set(S.subarray(0,d*2)),S=p}let b=d===0?new Array(t):this._singleLaneMeasurements.items.slice(),T;if(d===0)T=i+s;else{let p=d-1;T=S[p*2]+S[p*2+1]+c}for(let p=d;p<t;p++){let w=r(p);b[p]=w;let L=f.get(w),P=typeof L=="number"?L:this.options.estimateSize(p);S[p*2]=T,S[p*2+1]=P,T+=P+c}this._singleLaneMeasurements={flat:S,items:b};let M=U0(b,S);return this.measurementsCache=M,M}let y=this.measurementsCache.slice(0,d),v=new Array(a).fill(void 0),g=new Float64Array(a),_=0;for(let m=0;m<d;m++){let S=y[m];S&&(v[S.lane]===void 0&&_++,v[S.lane]=m,g[S.lane]=S.end)}for(let m=d;m<t;m++){let S=r(m),b=this.laneAssignments.get(m),T,M,p=l==="estimate"||f.has(S);if(b!==void 0&&this.options.lanes>1){T=b;let N=v[T],I=N!==void 0?y[N]:void 0;M=I?I.end+c:i+s}else if(_===a){let N=0,I=g[0],U=v[0];for(let D=1;D<a;D++){let V=g[D];(V<I||V===I&&v[D]<U)&&(N=D,I=V,U=v[D])}T=N,M=I+c,p&&this.laneAssignments.set(m,T)}else T=m%this.options.lanes,M=i+s,p&&this.laneAssignments.set(m,T);let w=f.get(S),L=typeof w=="number"?w:this.options.estimateSize(m),P=M+L;y[m]={index:m,start:M,size:L,end:P,key:S,lane:T},v[T]===void 0&&_++,v[T]=m,g[T]=P}return this.measurementsCache=y,y},{key:!1,debug:()=>this.options.debug}),this.calculateRange=Wr(()=>[this.getMeasurements(),this.getSize(),this.getScrollOffset(),this.options.lanes,this._getLayoutTotalSize()+this.options.scrollMargin],(t,i,s,r,o)=>{if(t.length===0||i===0)return this.range=null,null;let a=Math.max(o-i,0);return this.range=lM(t,i,Math.min(s,a),r,r===1&&this._singleLaneMeasurements!==null?this._singleLaneMeasurements.flat:null),this.range},{key:!1,debug:()=>this.options.debug}),this.getVirtualIndexes=Wr(()=>{let t=null,i=null,s=this.calculateRange();return s&&(t=s.startIndex,i=s.endIndex),this.maybeNotify.updateDeps([this.isScrolling,t,i]),[this.options.rangeExtractor,this.options.overscan,this.options.count,t,i,this.options.lanes]},(t,i,s,r,o,a)=>r===null||o===null?[]:t({startIndex:r,endIndex:o,overscan:i,count:s,lanes:a}),{key:!1,debug:()=>this.options.debug}),this.indexFromElement=t=>{let i=this.options.indexAttribute,s=t.getAttribute(i);return s?parseInt(s,10):(console.warn(`Missing attribute name '${i}={index}' on measured element.`),-1)},this.shouldMeasureDuringScroll=t=>{var i;if(!ja(this.scrollState))return!0;let s=this.scrollState.index??((i=this.getVirtualItemForOffset(this.scrollState.lastTargetOffset))==null?void 0:i.index);if(s!==void 0&&this.range){let r=Math.max(this.options.overscan,Math.ceil((this.range.endIndex-this.range.startIndex)/2)),o=Math.max(0,s-r),a=Math.min(this.options.count-1,s+r);return t>=o&&t<=a}return!0},this.measureElement=t=>{if(!t){this.elementsCache.forEach((o,a)=>{o.isConnected||(this.observer.unobserve(o),this.elementsCache.delete(a))});return}let i=this.indexFromElement(t);if(!this.isIndexInRange(i))return;let s=this.options.getItemKey(i),r=this.elementsCache.get(s);r!==t&&(r&&this.observer.unobserve(r),this.observer.observe(t),this.elementsCache.set(s,t)),t.isConnected&&(!this.isScrolling||this.scrollState)&&this.shouldMeasureDuringScroll(i)&&this.resizeItem(i,this.options.measureElement(t,void 0,this))},this.resizeItem=(t,i)=>{var s,r,o;if(!this.isIndexInRange(t))return;(s=this._resizeBatch)!=null&&s.sync&&this.getMeasurements();let a,l,c,u=(r=this._singleLaneMeasurements)==null?void 0:r.flat;if(this.options.lanes===1&&u!=null)c=this.options.getItemKey(t),l=u[t*2],a=u[t*2+1];else{let d=this.measurementsCache[t];if(!d)return;c=d.key,l=d.start,a=d.size}let h=this.itemSizeCache.get(c)??a,f=i-h;if(f!==0){let d=this.options.anchorTo==="end"&&!ja(this.scrollState)&&this.getVirtualDistanceFromEnd()<=this.options.scrollEndThreshold,y=d?this._getLayoutTotalSize():0,v=this.getScrollOffset(),_=!this.itemSizeCache.has(c)?l<v:l+h<=v&&this.scrollDirection!=="backward",m=!ja(this.scrollState)&&(this.shouldAdjustScrollPositionOnItemSizeChange!==void 0?this.shouldAdjustScrollPositionOnItemSizeChange(this.measurementsCache[t]??{index:t,key:c,start:l,size:a,end:l+a,lane:0},f,this):_);(this.pendingMin===null||t<this.pendingMin)&&(this.pendingMin=t),this.itemSizeCache.set(c,i),this.itemSizeCacheVersion++;let S=!1;if(this._awaitingCommandReadBack()||(d?S=this.applyScrollAdjustment(this._getLayoutTotalSize()-y):m&&(S=this.applyScrollAdjustment(f))),this._resizeBatch){this._resizeBatch.notify=!0,(o=this._resizeBatch).sync||(o.sync=S);return}this.notify(S),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment()}},this.getVirtualItems=Wr(()=>[this.getVirtualIndexes(),this.getMeasurements(),this._holdOffset],(t,i,s)=>{let r=[];for(let o=0,a=t.length;o<a;o++){let l=t[o],c=i[l];r.push(s===0?c:{...c,start:c.start-s,end:c.end-s})}return r},{key:!1,debug:()=>this.options.debug}),this.getVirtualItemForOffset=t=>{var i;let s=this.getMeasurements();if(s.length===0)return;let r=(i=this._singleLaneMeasurements)==null?void 0:i.flat,o=this.options.lanes===1&&r!=null,a=Z0(0,s.length-1,o?l=>r[l*2]:l=>ad(s[l]).start,t);return ad(s[a])},this._noteClampMax=()=>{if(!this._awaitingCommandReadBack())return;let t=this._elementMaxScrollOffset();if(t===null)return;let i=this.pendingWrite,s=Math.max(t,0)+this._holdOffset;if(s>=i.target)return;let r=i.lowMaxes??(i.lowMaxes=[]);r[r.length-1]!==s&&r.push(s)},this.getMaxScrollOffset=()=>(this._elementMaxScrollOffset()??0)+this._holdOffset,this._toLayoutOffset=t=>{var i;let s=t+this._holdOffset;return((i=this.pendingScrollAnchor)==null?void 0:i.kind)==="anchor"&&(s+=this.pendingScrollAnchor.delta),s},this._elementMaxScrollOffset=()=>{let t=this.scrollElement;if(t===null)return null;if("scrollHeight"in t)return this.options.horizontal?t.scrollWidth-t.clientWidth:t.scrollHeight-t.clientHeight;if("document"in t){let i=t.document.documentElement;return this.options.horizontal?i.scrollWidth-t.innerWidth:i.scrollHeight-t.innerHeight}return null},this._momentumStop=null,this._stopMomentum=t=>{let i=this.scrollElement,s=this.targetWindow;if(i===null||s===null)return;let r="document"in i?i.document.scrollingElement:i;if(!r?.style)return;if(this._momentumStop){this._momentumStop.done=t;return}let{style:o}=r,a=this.options.horizontal?"overflow-x":"overflow-y",l=o.getPropertyValue(a),c=o.getPropertyPriority(a),u=()=>this.options.horizontal?r.clientHeight:r.clientWidth,h=u();if(o.setProperty(a,"hidden","important"),u()!==h){o.setProperty(a,l,c);return}let f={restore:()=>o.getPropertyValue(a)!=="hidden"||o.getPropertyPriority(a)!=="important"?!1:(o.setProperty(a,l,c),!0),done:t};this._momentumStop=f,s.requestAnimationFrame(()=>s.requestAnimationFrame(()=>{this._momentumStop===f&&(this._momentumStop=null,f.restore()&&f.done())}))},this._clampedBy=t=>{let i=this._elementMaxScrollOffset();if(i===null)return null;let s=i+this._holdOffset;return t>s+.5?{target:t,maxAtWrite:s}:null},this.getVirtualDistanceFromEnd=()=>Math.max(this._getLayoutTotalSize()+this.options.scrollMargin-this.getSize()-this.getScrollOffset(),0),this.getDistanceFromEnd=()=>Math.max(this.getMaxScrollOffset()-this.getScrollOffset(),0),this.isAtEnd=(t=this.options.scrollEndThreshold)=>this.getDistanceFromEnd()<=t,this.getOffsetForAlignment=(t,i,s=0)=>{if(!this.scrollElement)return 0;let r=this.getSize(),o=this.getScrollOffset();i==="auto"&&(i=t>=o+r?"end":"start"),i==="center"?t+=(s-r)/2:i==="end"&&(t-=r);let a=this.getMaxScrollOffset();return Math.max(Math.min(a,t),0)},this.getOffsetForIndex=(t,i="auto")=>{t=Math.max(0,Math.min(t,this.options.count-1));let s=this.getSize(),r=this.getScrollOffset(),o=this.getMeasurements()[t];if(!o)return;if(i==="auto")if(o.end>=r+s-this.options.scrollPaddingEnd)i="end";else if(o.start<=r+this.options.scrollPaddingStart)i="start";else return[r,i];if(i==="end"&&t===this.options.count-1){let l=this.getMaxScrollOffset(),c=l-this.options.paddingEnd+this.options.scrollPaddingEnd;return[Math.max(Math.min(c,l),0),i]}let a=i==="end"?o.end+this.options.scrollPaddingEnd:o.start-this.options.scrollPaddingStart;return[this.getOffsetForAlignment(a,i,o.size),i]},this.scrollToOffset=(t,{align:i="start",behavior:s="auto"}={})=>{this._startScroll({index:null,align:i},this.getOffsetForAlignment(t,i),s,"absolute")},this.scrollToIndex=(t,{align:i="auto",behavior:s="auto"}={})=>{t=Math.max(0,Math.min(t,this.options.count-1));let r=this.getOffsetForIndex(t,i);if(!r)return;let[o,a]=r;this._startScroll({index:t,align:a},o,s,"absolute")},this.scrollBy=(t,{behavior:i="auto"}={})=>{let s=this.getOffsetForAlignment((this.getCommandWrittenOffset()??this.getScrollOffset())+t,"start");this._startScroll({index:null,align:"start"},s,i,"relative")},this.scrollToEnd=({behavior:t="auto"}={})=>{if(this.options.count>0){this._startScroll({index:this.options.count-1,align:"end",toEnd:!0},Math.max(this.getMaxScrollOffset(),0),t,"absolute");return}this.scrollToOffset(Math.max(this.getTotalSize()-this.getSize(),0),{behavior:t})},this.cancelScroll=()=>{this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null},this.getTotalSize=()=>Math.max(this._getLayoutTotalSize()-this._holdOffset,0),this._getLayoutTotalSize=()=>{var t,i;let s=this.getMeasurements(),r;if(s.length===0)r=this.options.paddingStart;else if(this.options.lanes===1){let o=s.length-1,a=(t=this._singleLaneMeasurements)==null?void 0:t.flat;a!=null?r=a[o*2]+a[o*2+1]:r=((i=s[o])==null?void 0:i.end)??0}else{let o=Array(this.options.lanes).fill(null),a=s.length-1;for(;a>=0&&o.some(l=>l===null);){let l=s[a];o[l.lane]===null&&(o[l.lane]=l.end),a--}r=Math.max(...o.filter(l=>l!==null))}return Math.max(r-this.options.scrollMargin+this.options.paddingEnd,0)},this.takeSnapshot=()=>{let t=[];if(this.itemSizeCache.size===0)return t;let i=this.getMeasurements();for(let s of i)s&&this.itemSizeCache.has(s.key)&&t.push({index:s.index,key:s.key,start:s.start,size:s.size,end:s.end,lane:s.lane});return t},this._scrollToOffset=(t,{adjustments:i,behavior:s}={})=>{let r={target:t+(i??0),smooth:s==="smooth"};return this.pendingWrite=r,this.options.scrollToFn(t-this._holdOffset,{behavior:s,adjustments:i},this),r},this.getCommandWrittenOffset=()=>this.scrollState!==null&&this.pendingWrite!==null&&!this.pendingWrite.smooth?this.pendingWrite.target:null,this._awaitingCommandReadBack=()=>{let t=this.getCommandWrittenOffset();return!(Ja()&&this._iosGesture.dragging())&&t!==null&&!Os(t,this.getScrollOffset())},this._followOffsetTarget=t=>{this.scrollState!==null&&this.scrollState.index==null&&(this.scrollState.lastTargetOffset+=t)},this.measure=()=>{this.pendingMin=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.itemSizeCacheVersion++,this.notify(!1)},this.setOptions(e)}get scrollAdjustments(){return 0}applyScrollAdjustment(e,t){if(e===0)return!1;if(this._followOffsetTarget(e),this._canWriteScroll()){let i=this.getScrollOffset();this._clampedAdjustment=this._clampedBy(i+e);let s=this._scrollToOffset(i,{adjustments:e,behavior:t});return this.scrollOffset!==null&&(this.pendingWrite===s&&(this.scrollOffset+=e),this.scrollOffset<0&&(this.scrollOffset=0)),!0}else return this._holdOffset+=e,this.scrollOffset!==null&&(this.scrollOffset+=e),!0}scheduleScrollReconcile(){if(!this.targetWindow){this.scrollState=null;return}this.rafId==null&&(this.rafId=this.targetWindow.requestAnimationFrame(()=>{this.rafId=null,this.reconcileScroll()}))}getScrollStateTarget(e){let t=e.toEnd?[Math.max(this.getMaxScrollOffset(),0)]:e.index!=null?this.getOffsetForIndex(e.index,e.align):void 0;return t?t[0]:e.lastTargetOffset}reconcileScroll(){if(!this.scrollState||!this.scrollElement)return;if(this.now()-this.scrollState.startedAt>5e3){this.scrollState=null;return}if(this.scrollState.phase==="queued"){this.scheduleScrollReconcile();return}this.getMeasurements();let i=this.getScrollStateTarget(this.scrollState),s=this.scrollState.index==null?1:this.options.useAnimationFrameWithResizeObserver?3:2,r=i!==this.scrollState.lastTargetOffset;if(!r&&Os(i,this.getScrollOffset())){if(this.scrollState.phase==="smooth"?this.scrollState.phase="smoothLanded":this.scrollState.phase==="smoothFinishing"&&(this.scrollState.phase="instant"),this.scrollState.stableFrames++,this.scrollState.stableFrames>=s){this.getScrollOffset()!==i&&this._scrollToOffset(i,{behavior:"auto"}),this.scrollState=null;return}}else if(this.scrollState.stableFrames=0,r){let o=this.getSize()||600,a=Math.abs(i-this.getScrollOffset()),l=ja(this.scrollState)&&a>o;this.scrollState.lastTargetOffset=i,l?this.scrollState.phase="smooth":this.scrollState.phase==="smooth"?this.scrollState.phase="smoothFinishing":this.scrollState.phase==="smoothLanded"&&(this.scrollState.phase="instant"),this._scrollToOffset(i,{behavior:l?"smooth":"auto"})}this.scheduleScrollReconcile()}_startScroll(e,t,i,s){this.pendingScrollAnchor=null,this._clampedAdjustment=null;let r=this._iosGesture.tail();if(s==="absolute"&&r!==null){if(r==="fling"&&H0()){this._stopMomentum(()=>{let o=this.scrollState;o?.phase!=="queued"||this._iosGesture.tail()!=="fling"||this._reportedOverscroll||(this._iosGesture.end(),this._flushHoldIfReady(!0),this._writeAwaitingCommand())}),this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,phase:"queued",behavior:i,samples:[]},this.scheduleScrollReconcile();return}this._iosGesture.end()}this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,behavior:i,phase:$0(i,e.index!=null&&Os(t,this.getScrollOffset()))},this._scrollToOffset(t,{behavior:i}),this.scheduleScrollReconcile()}},Z0=(n,e,t,i)=>{for(;n<=e;){let s=(n+e)/2|0,r=t(s);if(r<i)n=s+1;else if(r>i)e=s-1;else return s}return n>0?n-1:0};function aM(n,e,t){let i=0;for(;i<=e;){let s=(i+e)/2|0,r=n[s*2];if(r<t)i=s+1;else if(r>t)e=s-1;else return s}return i>0?i-1:0}function lM(n,e,t,i,s){let r=n.length-1;if(n.length<=i)return{startIndex:0,endIndex:r};if(i===1&&s!==null){let c=aM(s,r,t),u=c,h=t+e;for(;u<r&&s[u*2]+s[u*2+1]<h;)u++;return{startIndex:c,endIndex:u}}let a=Z0(0,r,c=>n[c].start,t),l=a;if(i===1)for(;l<r&&n[l].end<t+e;)l++;else if(i>1){let c=Array(i).fill(0);for(;l<r&&c.some(h=>h<t+e);){let h=n[l];c[h.lane]=h.end,l++}let u=Array(i).fill(t+e);for(;a>=0&&u.some(h=>h>=t);){let h=n[a];u[h.lane]=h.start,a--}a=Math.max(0,a-a%i),l=Math.min(r,l+(i-1-l%i))}return{startIndex:a,endIndex:l}}var wr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2};var I_=0,Vd=1,L_=2;var Il=1,N_=2,da=3,Tr=0,ui=1,di=2,Qr=0,pa=1,Gd=2,Hd=3,Wd=4,D_=5;var eo=100,O_=101,F_=102,U_=103,B_=104,k_=200,z_=201,V_=202,G_=203,Xd=204,$d=205,H_=206,W_=207,X_=208,$_=209,q_=210,Y_=211,J_=212,j_=213,Z_=214,ru=0,ou=1,au=2,na=3,lu=4,cu=5,uu=6,hu=7,Fu=0,K_=1,Q_=2,bs=0,qd=1,Yd=2,Jd=3,jd=4,Zd=5,Kd=6,Qd=7;var ep=300,to=301,ma=302,Uu=303,Bu=304,fu=1e3,xs=1001,du=1002,Bn=1003,ex=1004;var Ll=1005;var ci=1006,ku=1007;var js=1008;var pi=1009,tp=1010,np=1011,ga=1012,zu=1013,is=1014,Vi=1015,ss=1016,Vu=1017,Gu=1018,no=1020,ip=35902,sp=35899,rp=1021,op=1022,rs=1023,Hs=1026,Zs=1027,Hu=1028,Wu=1029,Ar=1030,Xu=1031;var $u=1033,Nl=33776,Dl=33777,Ol=33778,Fl=33779,qu=35840,Yu=35841,Ju=35842,ju=35843,Zu=36196,Ku=37492,Qu=37496,eh=37488,th=37489,Ul=37490,nh=37491,ih=37808,sh=37809,rh=37810,oh=37811,ah=37812,lh=37813,ch=37814,uh=37815,hh=37816,fh=37817,dh=37818,ph=37819,mh=37820,gh=37821,_h=36492,xh=36494,yh=36495,vh=36283,bh=36284,Bl=36285,Sh=36286;var al=2300,pu=2301,iu=2302,Id=2303,Ld=2400,Nd=2401,Dd=2402;var tx=3200;var Mh=0,nx=1,Ks="",Kn="srgb",ll="srgb-linear",cl="linear",It="srgb";var su=7680;var ix=519,sx=512,rx=513,ox=514,ap=515,ax=516,lx=517,lp=518,cp=519,cx=35044;var up="300 es",ki=2e3,ia=2001;function cM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function uM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ul(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function ux(){let n=ul("canvas");return n.style.display="block",n}var K0={},sa=null;function hp(...n){let e="THREE."+n.shift();sa?sa("log",e,...n):console.log(e,...n)}function hx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=hx(n);let e="THREE."+n.shift();if(sa)sa("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=hx(n);let e="THREE."+n.shift();if(sa)sa("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function sl(...n){let e=n.join(" ");e in K0||(K0[e]=!0,Ye(...n))}function fx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var dx={[ru]:ru,[au]:uu,[lu]:lu,[na]:cu,[ou]:ou,[uu]:au,[hu]:hu,[cu]:na},ts=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Q0=1234567,rl=Math.PI/180,ra=180/Math.PI;function _a(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(jn[n&255]+jn[n>>8&255]+jn[n>>16&255]+jn[n>>24&255]+"-"+jn[e&255]+jn[e>>8&255]+"-"+jn[e>>16&15|64]+jn[e>>24&255]+"-"+jn[t&63|128]+jn[t>>8&255]+"-"+jn[t>>16&255]+jn[t>>24&255]+jn[i&255]+jn[i>>8&255]+jn[i>>16&255]+jn[i>>24&255]).toLowerCase()}function bt(n,e,t){return Math.max(e,Math.min(t,n))}function fp(n,e){return(n%e+e)%e}function hM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function fM(n,e,t){return n!==e?(t-n)/(e-n):0}function ol(n,e,t){return(1-t)*n+t*e}function dM(n,e,t,i){return ol(n,e,1-Math.exp(-t*i))}function pM(n,e=1){return e-Math.abs(fp(n,e*2)-e)}function mM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function gM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function _M(n,e){return n+Math.floor(Math.random()*(e-n+1))}function xM(n,e){return n+Math.random()*(e-n)}function yM(n){return n*(.5-Math.random())}function vM(n){n!==void 0&&(Q0=n);let e=Q0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function bM(n){return n*rl}function SM(n){return n*ra}function MM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function wM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function dp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function TM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),y=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*y,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*y,a*c);break;case"ZYZ":n.set(l*y,l*d,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function pp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function px(n,e){if(e.constructor===Float32Array)return n;let t=pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function mx(n,e){if(e.constructor===Float32Array)return n;let t=pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var wh={DEG2RAD:rl,RAD2DEG:ra,generateUUID:_a,clamp:bt,euclideanModulo:fp,mapLinear:hM,inverseLerp:fM,lerp:ol,damp:dM,pingpong:pM,smoothstep:mM,smootherstep:gM,randInt:_M,randFloat:xM,randFloatSpread:yM,seededRandom:vM,degToRad:bM,radToDeg:SM,isPowerOfTwo:MM,ceilPowerOfTwo:wM,floorPowerOfTwo:dp,setQuaternionFromProperEuler:TM,normalize:mx,denormalize:px},Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Sn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],y=r[o+2],v=r[o+3];if(h!==v||l!==f||c!==d||u!==y){let g=l*f+c*d+u*y+h*v;g<0&&(f=-f,d=-d,y=-y,v=-v,g=-g);let _=1-a;if(g<.9995){let m=Math.acos(g),S=Math.sin(m);_=Math.sin(_*m)/S,a=Math.sin(a*m)/S,l=l*_+f*a,c=c*_+d*a,u=u*_+y*a,h=h*_+v*a}else{l=l*_+f*a,c=c*_+d*a,u=u*_+y*a,h=h*_+v*a;let m=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=m,c*=m,u*=m,h*=m}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],y=r[o+3];return e[t]=a*y+u*h+l*d-c*f,e[t+1]=l*y+u*f+c*h-a*d,e[t+2]=c*y+u*d+a*f-l*h,e[t+3]=u*y-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),y=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h-f*d*y;break;case"YXZ":this._x=f*u*h+c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h+f*d*y;break;case"ZXY":this._x=f*u*h-c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h-f*d*y;break;case"ZYX":this._x=f*u*h-c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h+f*d*y;break;case"YZX":this._x=f*u*h+c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h-f*d*y;break;case"XZY":this._x=f*u*h-c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h+f*d*y;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(bt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(e_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(e_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return ud.copy(this).projectOnVector(e),this.sub(ud)}reflect(e){return this.sub(ud.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ud=new X,e_=new Sn,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],y=i[8],v=s[0],g=s[3],_=s[6],m=s[1],S=s[4],b=s[7],T=s[2],M=s[5],p=s[8];return r[0]=o*v+a*m+l*T,r[3]=o*g+a*S+l*M,r[6]=o*_+a*b+l*p,r[1]=c*v+u*m+h*T,r[4]=c*g+u*S+h*M,r[7]=c*_+u*b+h*p,r[2]=f*v+d*m+y*T,r[5]=f*g+d*S+y*M,r[8]=f*_+d*b+y*p,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,y=t*h+i*f+s*d;if(y===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/y;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return sl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hd.makeScale(e,t)),this}rotate(e){return sl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hd.makeRotation(-e)),this}translate(e,t){return sl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hd=new nt,t_=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),n_=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function AM(){let n={enabled:!0,workingColorSpace:ll,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=Gs(s.r),s.g=Gs(s.g),s.b=Gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=ta(s.r),s.g=ta(s.g),s.b=ta(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ks?cl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ll]:{primaries:e,whitePoint:i,transfer:cl,toXYZ:t_,fromXYZ:n_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Kn},outputColorSpaceConfig:{drawingBufferColorSpace:Kn}},[Kn]:{primaries:e,whitePoint:i,transfer:It,toXYZ:t_,fromXYZ:n_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Kn}}}),n}var vt=AM();function Gs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ta(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vo,mu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Vo===void 0&&(Vo=ul("canvas")),Vo.width=e.width,Vo.height=e.height;let s=Vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Vo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ul("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Gs(t[i]/255)*255):t[i]=Gs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},EM=0,oa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:EM++}),this.uuid=_a(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(fd(s[o].image)):r.push(fd(s[o]))}else r=fd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function fd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?mu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var CM=0,dd=new X,fi=class n extends ts{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=xs,s=xs,r=ci,o=js,a=rs,l=pi,c=n.DEFAULT_ANISOTROPY,u=Ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:CM++}),this.uuid=_a(),this.name="",this.source=new oa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(dd).x}get height(){return this.source.getSize(dd).y}get depth(){return this.source.getSize(dd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ep)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fu:e.x=e.x-Math.floor(e.x);break;case xs:e.x=e.x<0?0:1;break;case du:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fu:e.y=e.y-Math.floor(e.y);break;case xs:e.y=e.y<0?0:1;break;case du:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};fi.DEFAULT_IMAGE=null;fi.DEFAULT_MAPPING=ep;fi.DEFAULT_ANISOTROPY=1;var kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],y=l[9],v=l[2],g=l[6],_=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(y-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(y+g)<.1&&Math.abs(c+d+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,b=(d+1)/2,T=(_+1)/2,M=(u+f)/4,p=(h+v)/4,w=(y+g)/4;return S>b&&S>T?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=M/i,r=p/i):b>T?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=w/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=p/r,s=w/r),this.set(i,s,r,t),this}let m=Math.sqrt((g-y)*(g-y)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(m)<.001&&(m=1),this.x=(g-y)/m,this.y=(h-v)/m,this.z=(f-u)/m,this.w=Math.acos((c+d+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this.w=bt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this.w=bt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},gu=class extends ts{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ci,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new kt(0,0,e,t),this.scissorTest=!1,this.viewport=new kt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new fi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ci,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new oa(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends gu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},hl=class extends fi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var _u=class extends fi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=xs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g){let _=this.elements;return _[0]=e,_[4]=t,_[8]=i,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=h,_[14]=f,_[3]=d,_[7]=y,_[11]=v,_[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Go.setFromMatrixColumn(e,0).length(),r=1/Go.setFromMatrixColumn(e,1).length(),o=1/Go.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,y=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+y*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=y+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,y=c*u,v=c*h;t[0]=f+v*a,t[4]=y*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-y,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,y=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=y+d*a,t[1]=d+y*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,y=a*u,v=a*h;t[0]=l*u,t[4]=y*c-d,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=d*c-y,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,y=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=y*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+y,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,d=o*c,y=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=d*h-y,t[2]=y*h-d,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(RM,e,PM)}lookAt(e,t,i){let s=this.elements;return Ai.subVectors(e,t),Ai.lengthSq()===0&&(Ai.z=1),Ai.normalize(),dr.crossVectors(i,Ai),dr.lengthSq()===0&&(Math.abs(i.z)===1?Ai.x+=1e-4:Ai.z+=1e-4,Ai.normalize(),dr.crossVectors(i,Ai)),dr.normalize(),Dc.crossVectors(Ai,dr),s[0]=dr.x,s[4]=Dc.x,s[8]=Ai.x,s[1]=dr.y,s[5]=Dc.y,s[9]=Ai.y,s[2]=dr.z,s[6]=Dc.z,s[10]=Ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],y=i[2],v=i[6],g=i[10],_=i[14],m=i[3],S=i[7],b=i[11],T=i[15],M=s[0],p=s[4],w=s[8],L=s[12],P=s[1],N=s[5],I=s[9],U=s[13],D=s[2],V=s[6],Y=s[10],W=s[14],ae=s[3],G=s[7],j=s[11],te=s[15];return r[0]=o*M+a*P+l*D+c*ae,r[4]=o*p+a*N+l*V+c*G,r[8]=o*w+a*I+l*Y+c*j,r[12]=o*L+a*U+l*W+c*te,r[1]=u*M+h*P+f*D+d*ae,r[5]=u*p+h*N+f*V+d*G,r[9]=u*w+h*I+f*Y+d*j,r[13]=u*L+h*U+f*W+d*te,r[2]=y*M+v*P+g*D+_*ae,r[6]=y*p+v*N+g*V+_*G,r[10]=y*w+v*I+g*Y+_*j,r[14]=y*L+v*U+g*W+_*te,r[3]=m*M+S*P+b*D+T*ae,r[7]=m*p+S*N+b*V+T*G,r[11]=m*w+S*I+b*Y+T*j,r[15]=m*L+S*U+b*W+T*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],y=e[3],v=e[7],g=e[11],_=e[15],m=l*d-c*f,S=a*d-c*h,b=a*f-l*h,T=o*d-c*u,M=o*f-l*u,p=o*h-a*u;return t*(v*m-g*S+_*b)-i*(y*m-g*T+_*M)+s*(y*S-v*T+_*p)-r*(y*b-v*M+g*p)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],y=e[12],v=e[13],g=e[14],_=e[15],m=t*a-i*o,S=t*l-s*o,b=t*c-r*o,T=i*l-s*a,M=i*c-r*a,p=s*c-r*l,w=u*v-h*y,L=u*g-f*y,P=u*_-d*y,N=h*g-f*v,I=h*_-d*v,U=f*_-d*g,D=m*U-S*I+b*N+T*P-M*L+p*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return e[0]=(a*U-l*I+c*N)*V,e[1]=(s*I-i*U-r*N)*V,e[2]=(v*p-g*M+_*T)*V,e[3]=(f*M-h*p-d*T)*V,e[4]=(l*P-o*U-c*L)*V,e[5]=(t*U-s*P+r*L)*V,e[6]=(g*b-y*p-_*S)*V,e[7]=(u*p-f*b+d*S)*V,e[8]=(o*I-a*P+c*w)*V,e[9]=(i*P-t*I-r*w)*V,e[10]=(y*M-v*b+_*m)*V,e[11]=(h*b-u*M-d*m)*V,e[12]=(a*L-o*N-l*w)*V,e[13]=(t*N-i*L+s*w)*V,e[14]=(v*S-y*T-g*m)*V,e[15]=(u*T-h*S+f*m)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,y=r*h,v=o*u,g=o*h,_=a*h,m=l*c,S=l*u,b=l*h,T=i.x,M=i.y,p=i.z;return s[0]=(1-(v+_))*T,s[1]=(d+b)*T,s[2]=(y-S)*T,s[3]=0,s[4]=(d-b)*M,s[5]=(1-(f+_))*M,s[6]=(g+m)*M,s[7]=0,s[8]=(y+S)*p,s[9]=(g-m)*p,s[10]=(1-(f+v))*p,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Go.set(s[0],s[1],s[2]).length(),a=Go.set(s[4],s[5],s[6]).length(),l=Go.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Zi.copy(this);let c=1/o,u=1/a,h=1/l;return Zi.elements[0]*=c,Zi.elements[1]*=c,Zi.elements[2]*=c,Zi.elements[4]*=u,Zi.elements[5]*=u,Zi.elements[6]*=u,Zi.elements[8]*=h,Zi.elements[9]*=h,Zi.elements[10]*=h,t.setFromRotationMatrix(Zi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),y,v;if(l)y=r/(o-r),v=o*r/(o-r);else if(a===ki)y=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===ia)y=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=y,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),y,v;if(l)y=1/(o-r),v=o/(o-r);else if(a===ki)y=-2/(o-r),v=-(o+r)/(o-r);else if(a===ia)y=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=y,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Go=new X,Zi=new gt,RM=new X(0,0,0),PM=new X(1,1,1),dr=new X,Dc=new X,Ai=new X,i_=new gt,s_=new Sn,Ws=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(bt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-bt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(bt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-bt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(bt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-bt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return i_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(i_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return s_.setFromEuler(this),this.setFromQuaternion(s_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ws.DEFAULT_ORDER="XYZ";var aa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},IM=0,r_=new X,Ho=new Sn,Fs=new gt,Oc=new X,Za=new X,LM=new X,NM=new Sn,o_=new X(1,0,0),a_=new X(0,1,0),l_=new X(0,0,1),c_={type:"added"},DM={type:"removed"},Wo={type:"childadded",child:null},pd={type:"childremoved",child:null},Hn=class n extends ts{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:IM++}),this.uuid=_a(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new Ws,i=new Sn,s=new X(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new gt},normalMatrix:{value:new nt}}),this.matrix=new gt,this.matrixWorld=new gt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new aa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ho.setFromAxisAngle(e,t),this.quaternion.multiply(Ho),this}rotateOnWorldAxis(e,t){return Ho.setFromAxisAngle(e,t),this.quaternion.premultiply(Ho),this}rotateX(e){return this.rotateOnAxis(o_,e)}rotateY(e){return this.rotateOnAxis(a_,e)}rotateZ(e){return this.rotateOnAxis(l_,e)}translateOnAxis(e,t){return r_.copy(e).applyQuaternion(this.quaternion),this.position.add(r_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(o_,e)}translateY(e){return this.translateOnAxis(a_,e)}translateZ(e){return this.translateOnAxis(l_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Fs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Oc.copy(e):Oc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Za.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Fs.lookAt(Za,Oc,this.up):Fs.lookAt(Oc,Za,this.up),this.quaternion.setFromRotationMatrix(Fs),s&&(Fs.extractRotation(s.matrixWorld),Ho.setFromRotationMatrix(Fs),this.quaternion.premultiply(Ho.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(c_),Wo.child=e,this.dispatchEvent(Wo),Wo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(DM),pd.child=e,this.dispatchEvent(pd),pd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Fs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Fs.multiply(e.parent.matrixWorld)),e.applyMatrix4(Fs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(c_),Wo.child=e,this.dispatchEvent(Wo),Wo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,e,LM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,NM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),y=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),y.length>0&&(i.nodes=y)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Hn.DEFAULT_UP=new X(0,1,0);Hn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Hn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ys=class extends Hn{constructor(){super(),this.isGroup=!0,this.type="Group"}},OM={type:"move"},la=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ys,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ys,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ys,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),_=this._getHandJoint(c,v);g!==null&&(_.matrix.fromArray(g.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=g.radius),_.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,y=.005;c.inputState.pinching&&f>d+y?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-y&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(OM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ys;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},gx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},pr={h:0,s:0,l:0},Fc={h:0,s:0,l:0};function md(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var st=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Kn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=fp(e,1),t=bt(t,0,1),i=bt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=md(o,r,e+1/3),this.g=md(o,r,e),this.b=md(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Kn){function i(r){r!==void 0&&parseFloat(r)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Kn){let i=gx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gs(e.r),this.g=Gs(e.g),this.b=Gs(e.b),this}copyLinearToSRGB(e){return this.r=ta(e.r),this.g=ta(e.g),this.b=ta(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Kn){return vt.workingToColorSpace(Zn.copy(this),e),Math.round(bt(Zn.r*255,0,255))*65536+Math.round(bt(Zn.g*255,0,255))*256+Math.round(bt(Zn.b*255,0,255))}getHexString(e=Kn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Zn.copy(this),t);let i=Zn.r,s=Zn.g,r=Zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Zn.copy(this),t),e.r=Zn.r,e.g=Zn.g,e.b=Zn.b,e}getStyle(e=Kn){vt.workingToColorSpace(Zn.copy(this),e);let t=Zn.r,i=Zn.g,s=Zn.b;return e!==Kn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(pr),this.setHSL(pr.h+e,pr.s+t,pr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(pr),e.getHSL(Fc);let i=ol(pr.h,Fc.h,t),s=ol(pr.s,Fc.s,t),r=ol(pr.l,Fc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Zn=new st;st.NAMES=gx;var ns=class extends Hn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ws,this.environmentIntensity=1,this.environmentRotation=new Ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ki=new X,Us=new X,gd=new X,Bs=new X,Xo=new X,$o=new X,u_=new X,_d=new X,xd=new X,yd=new X,vd=new kt,bd=new kt,Sd=new kt,xr=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ki.subVectors(e,t),s.cross(Ki);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ki.subVectors(s,t),Us.subVectors(i,t),gd.subVectors(e,t);let o=Ki.dot(Ki),a=Ki.dot(Us),l=Ki.dot(gd),c=Us.dot(Us),u=Us.dot(gd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,y=(o*u-a*l)*f;return r.set(1-d-y,y,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Bs)===null?!1:Bs.x>=0&&Bs.y>=0&&Bs.x+Bs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Bs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Bs.x),l.addScaledVector(o,Bs.y),l.addScaledVector(a,Bs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return vd.setScalar(0),bd.setScalar(0),Sd.setScalar(0),vd.fromBufferAttribute(e,t),bd.fromBufferAttribute(e,i),Sd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(vd,r.x),o.addScaledVector(bd,r.y),o.addScaledVector(Sd,r.z),o}static isFrontFacing(e,t,i,s){return Ki.subVectors(i,t),Us.subVectors(e,t),Ki.cross(Us).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ki.subVectors(this.c,this.b),Us.subVectors(this.a,this.b),Ki.cross(Us).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Xo.subVectors(s,i),$o.subVectors(r,i),_d.subVectors(e,i);let l=Xo.dot(_d),c=$o.dot(_d);if(l<=0&&c<=0)return t.copy(i);xd.subVectors(e,s);let u=Xo.dot(xd),h=$o.dot(xd);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Xo,o);yd.subVectors(e,r);let d=Xo.dot(yd),y=$o.dot(yd);if(y>=0&&d<=y)return t.copy(r);let v=d*c-l*y;if(v<=0&&c>=0&&y<=0)return a=c/(c-y),t.copy(i).addScaledVector($o,a);let g=u*y-d*h;if(g<=0&&h-u>=0&&d-y>=0)return u_.subVectors(r,s),a=(h-u)/(h-u+(d-y)),t.copy(s).addScaledVector(u_,a);let _=1/(g+v+f);return o=v*_,a=f*_,t.copy(i).addScaledVector(Xo,o).addScaledVector($o,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},vs=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Qi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Qi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Qi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Qi):Qi.fromBufferAttribute(r,o),Qi.applyMatrix4(e.matrixWorld),this.expandByPoint(Qi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Uc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Uc.copy(i.boundingBox)),Uc.applyMatrix4(e.matrixWorld),this.union(Uc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Qi),Qi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ka),Bc.subVectors(this.max,Ka),qo.subVectors(e.a,Ka),Yo.subVectors(e.b,Ka),Jo.subVectors(e.c,Ka),mr.subVectors(Yo,qo),gr.subVectors(Jo,Yo),Xr.subVectors(qo,Jo);let t=[0,-mr.z,mr.y,0,-gr.z,gr.y,0,-Xr.z,Xr.y,mr.z,0,-mr.x,gr.z,0,-gr.x,Xr.z,0,-Xr.x,-mr.y,mr.x,0,-gr.y,gr.x,0,-Xr.y,Xr.x,0];return!Md(t,qo,Yo,Jo,Bc)||(t=[1,0,0,0,1,0,0,0,1],!Md(t,qo,Yo,Jo,Bc))?!1:(kc.crossVectors(mr,gr),t=[kc.x,kc.y,kc.z],Md(t,qo,Yo,Jo,Bc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Qi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Qi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ks[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ks[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ks[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ks[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ks[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ks[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ks[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ks[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ks),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ks=[new X,new X,new X,new X,new X,new X,new X,new X],Qi=new X,Uc=new vs,qo=new X,Yo=new X,Jo=new X,mr=new X,gr=new X,Xr=new X,Ka=new X,Bc=new X,kc=new X,$r=new X;function Md(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){$r.fromArray(n,r);let a=s.x*Math.abs($r.x)+s.y*Math.abs($r.y)+s.z*Math.abs($r.z),l=e.dot($r),c=t.dot($r),u=i.dot($r);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var bn=new X,zc=new Ke,FM=0,Ft=class extends ts{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:FM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=cx,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=e!==void 0?pp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)zc.fromBufferAttribute(this,t),zc.applyMatrix3(e),this.setXY(t,zc.x,zc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix3(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix4(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.applyNormalMatrix(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)bn.fromBufferAttribute(this,t),bn.transformDirection(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):px(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):mx(e,this.array)}},fl=class extends Ft{constructor(e,t,i){super(new Int8Array(e),t,i)}},dl=class extends Ft{constructor(e,t,i){super(new Uint8Array(e),t,i)}};var pl=class extends Ft{constructor(e,t,i){super(new Int16Array(e),t,i)}},Jr=class extends Ft{constructor(e,t,i){super(new Uint16Array(e),t,i)}},ml=class extends Ft{constructor(e,t,i){super(new Int32Array(e),t,i)}},jr=class extends Ft{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Cn=class extends Ft{constructor(e,t,i){super(new Float32Array(e),t,i)}},UM=new vs,Qa=new X,wd=new X,Xs=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):UM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Qa.subVectors(e,this.center);let t=Qa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Qa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Qa.copy(e.center).add(wd)),this.expandByPoint(Qa.copy(e.center).sub(wd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},BM=0,Bi=new gt,Td=new Hn,jo=new X,Ei=new vs,el=new vs,Un=new X,Qn=class n extends ts{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:BM++}),this.uuid=_a(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(cM(e)?jr:Jr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Bi.makeRotationFromQuaternion(e),this.applyMatrix4(Bi),this}rotateX(e){return Bi.makeRotationX(e),this.applyMatrix4(Bi),this}rotateY(e){return Bi.makeRotationY(e),this.applyMatrix4(Bi),this}rotateZ(e){return Bi.makeRotationZ(e),this.applyMatrix4(Bi),this}translate(e,t,i){return Bi.makeTranslation(e,t,i),this.applyMatrix4(Bi),this}scale(e,t,i){return Bi.makeScale(e,t,i),this.applyMatrix4(Bi),this}lookAt(e){return Td.lookAt(e),Td.updateMatrix(),this.applyMatrix4(Td.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jo).negate(),this.translate(jo.x,jo.y,jo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new vs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ei.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,Ei.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,Ei.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(Ei.min),this.boundingBox.expandByPoint(Ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Xs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(Ei.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];el.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(Ei.min,el.min),Ei.expandByPoint(Un),Un.addVectors(Ei.max,el.max),Ei.expandByPoint(Un)):(Ei.expandByPoint(el.min),Ei.expandByPoint(el.max))}Ei.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Un.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Un));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Un.fromBufferAttribute(a,c),l&&(jo.fromBufferAttribute(e,c),Un.add(jo)),s=Math.max(s,i.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ft(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new X,l[L]=new X;let u=new X,h=new X,f=new X,d=new Ke,y=new Ke,v=new Ke,g=new X,_=new X;function m(L,P,N){c[L]=c[P]=c[N]=1,u.fromBufferAttribute(i,L),h.fromBufferAttribute(i,P),f.fromBufferAttribute(i,N),d.fromBufferAttribute(r,L),y.fromBufferAttribute(r,P),v.fromBufferAttribute(r,N),h.sub(u),f.sub(u),y.sub(d),v.sub(d);let I=1/(y.x*v.y-v.x*y.y);isFinite(I)&&(g.copy(h).multiplyScalar(v.y).addScaledVector(f,-y.y).multiplyScalar(I),_.copy(f).multiplyScalar(y.x).addScaledVector(h,-v.x).multiplyScalar(I),a[L].add(g),a[P].add(g),a[N].add(g),l[L].add(_),l[P].add(_),l[N].add(_))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let L=0,P=S.length;L<P;++L){let N=S[L],I=N.start,U=N.count;for(let D=I,V=I+U;D<V;D+=3)m(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let b=new X,T=new X,M=new X,p=new X;function w(L){M.fromBufferAttribute(s,L),p.copy(M);let P=a[L];b.copy(P),b.sub(M.multiplyScalar(M.dot(P))).normalize(),T.crossVectors(p,P);let I=T.dot(l[L])<0?-1:1;o.setXYZW(L,b.x,b.y,b.z,I)}for(let L=0,P=i.count;L<P;++L)c[L]&&w(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ft(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,h=new X;if(e)for(let f=0,d=e.count;f<d;f+=3){let y=e.getX(f+0),v=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,y),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,y),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(y,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Un.fromBufferAttribute(e,t),Un.normalize(),e.setXYZ(t,Un.x,Un.y,Un.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,y=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let _=0;_<u;_++)f[y++]=c[d++]}return new Ft(f,u,h)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ad=new X,kM=new X,zM=new nt,es=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Ad.subVectors(i,t).cross(kM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Ad),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||zM.getNormalMatrix(e),s=this.coplanarPoint(Ad).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},VM=0,$s=class extends ts{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:VM++}),this.uuid=_a(),this.name="",this.type="Material",this.blending=pa,this.side=Tr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xd,this.blendDst=$d,this.blendEquation=eo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new st(0,0,0),this.blendAlpha=0,this.depthFunc=na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ix,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=su,this.stencilZFail=su,this.stencilZPass=su,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new st().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new es().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var zs=new X,Ed=new X,Vc=new X,Gc=new X,ca=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,zs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=zs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(zs.copy(this.origin).addScaledVector(this.direction,t),zs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ed.copy(e).add(t).multiplyScalar(.5),Vc.copy(t).sub(e).normalize(),Gc.copy(this.origin).sub(Ed);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Vc),a=Gc.dot(this.direction),l=-Gc.dot(Vc),c=Gc.lengthSq(),u=Math.abs(1-o*o),h,f,d,y;if(u>0)if(h=o*l-a,f=o*a-l,y=r*u,h>=0)if(f>=-y)if(f<=y){let v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-y?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=y?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ed).addScaledVector(Vc,f),d}intersectSphere(e,t){if(e.radius<0)return null;zs.subVectors(e.center,this.origin);let i=zs.dot(this.direction),s=zs.dot(zs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,zs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,y=t.x-o.x,v=t.y-o.y,g=t.z-o.z,_=i.x-o.x,m=i.y-o.y,S=i.z-o.z,b=Math.abs(l),T=Math.abs(c),M=Math.abs(u),p,w,L,P,N,I,U,D,V,Y,W,ae;if(b>=T&&b>=M?(L=l,I=h,V=y,ae=_,l>=0?(p=c,w=u,P=f,N=d,U=v,D=g,Y=m,W=S):(p=u,w=c,P=d,N=f,U=g,D=v,Y=S,W=m)):T>=M?(L=c,I=f,V=v,ae=m,c>=0?(p=u,w=l,P=d,N=h,U=g,D=y,Y=S,W=_):(p=l,w=u,P=h,N=d,U=y,D=g,Y=_,W=S)):(L=u,I=d,V=g,ae=S,u>=0?(p=l,w=c,P=h,N=f,U=y,D=v,Y=_,W=m):(p=c,w=l,P=f,N=h,U=v,D=y,Y=m,W=_)),L===0)return null;let G=p/L,j=w/L,te=1/L,ue=P-G*I,K=N-j*I,q=U-G*V,le=D-j*V,fe=Y-G*ae,ge=W-j*ae,xe=fe*le-ge*q,Ue=ue*ge-K*fe,Je=q*K-le*ue;if(s){if(xe<0||Ue<0||Je<0)return null}else if((xe<0||Ue<0||Je<0)&&(xe>0||Ue>0||Je>0))return null;let Ge=xe+Ue+Je;if(Ge===0)return null;let ft=te*(xe*I+Ue*V+Je*ae);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},qs=class extends $s{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ws,this.combine=Fu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},h_=new gt,qr=new ca,Hc=new Xs,f_=new X,Wc=new X,Xc=new X,$c=new X,Cd=new X,qc=new X,d_=new X,Yc=new X,Mn=class extends Hn{constructor(e=new Qn,t=new qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){qc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Cd.fromBufferAttribute(h,e),o?qc.addScaledVector(Cd,u):qc.addScaledVector(Cd.sub(t),u))}t.add(qc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Hc.copy(i.boundingSphere),Hc.applyMatrix4(r),qr.copy(e.ray).recast(e.near),!(Hc.containsPoint(qr.origin)===!1&&(qr.intersectSphere(Hc,f_)===null||qr.origin.distanceToSquared(f_)>(e.far-e.near)**2))&&(h_.copy(r).invert(),qr.copy(e.ray).applyMatrix4(h_),!(i.boundingBox!==null&&qr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let y=0,v=f.length;y<v;y++){let g=f[y],_=o[g.materialIndex],m=Math.max(g.start,d.start),S=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let b=m,T=S;b<T;b+=3){let M=a.getX(b),p=a.getX(b+1),w=a.getX(b+2);s=Jc(this,_,e,i,c,u,h,M,p,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let y=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let g=y,_=v;g<_;g+=3){let m=a.getX(g),S=a.getX(g+1),b=a.getX(g+2);s=Jc(this,o,e,i,c,u,h,m,S,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let y=0,v=f.length;y<v;y++){let g=f[y],_=o[g.materialIndex],m=Math.max(g.start,d.start),S=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let b=m,T=S;b<T;b+=3){let M=b,p=b+1,w=b+2;s=Jc(this,_,e,i,c,u,h,M,p,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let y=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let g=y,_=v;g<_;g+=3){let m=g,S=g+1,b=g+2;s=Jc(this,o,e,i,c,u,h,m,S,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function GM(n,e,t,i,s,r,o,a){let l;if(e.side===ui?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Tr,a),l===null)return null;Yc.copy(a),Yc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Yc);return c<t.near||c>t.far?null:{distance:c,point:Yc.clone(),object:n}}function Jc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Wc),n.getVertexPosition(l,Xc),n.getVertexPosition(c,$c);let u=GM(n,e,t,i,Wc,Xc,$c,d_);if(u){let h=new X;xr.getBarycoord(d_,Wc,Xc,$c,h),s&&(u.uv=xr.getInterpolatedAttribute(s,a,l,c,h,new Ke)),r&&(u.uv1=xr.getInterpolatedAttribute(r,a,l,c,h,new Ke)),o&&(u.normal=xr.getInterpolatedAttribute(o,a,l,c,h,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new X,materialIndex:0};xr.getNormal(Wc,Xc,$c,f.normal),u.face=f,u.barycoord=h}return u}var Ys=class extends fi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Bn,u=Bn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var gl=class extends Ft{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Zo=new gt,p_=new gt,jc=[],m_=new vs,HM=new gt,tl=new Mn,nl=new Xs,_l=class extends Mn{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new gl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,HM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new vs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zo),m_.copy(e.boundingBox).applyMatrix4(Zo),this.boundingBox.union(m_)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Xs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Zo),nl.copy(e.boundingSphere).applyMatrix4(Zo),this.boundingSphere.union(nl)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(tl.geometry=this.geometry,tl.material=this.material,tl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),nl.copy(this.boundingSphere),nl.applyMatrix4(i),e.ray.intersectsSphere(nl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Zo),p_.multiplyMatrices(i,Zo),tl.matrixWorld=p_,tl.raycast(e,jc);for(let o=0,a=jc.length;o<a;o++){let l=jc[o];l.instanceId=r,l.object=this,t.push(l)}jc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new gl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ys(new Float32Array(s*this.count),s,this.count,Hu,Vi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Yr=new Xs,WM=new Ke(.5,.5),Zc=new X,yr=class{constructor(e=new es,t=new es,i=new es,s=new es,r=new es,o=new es){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ki,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],y=r[8],v=r[9],g=r[10],_=r[11],m=r[12],S=r[13],b=r[14],T=r[15];if(s[0].setComponents(c-o,d-u,_-y,T-m).normalize(),s[1].setComponents(c+o,d+u,_+y,T+m).normalize(),s[2].setComponents(c+a,d+h,_+v,T+S).normalize(),s[3].setComponents(c-a,d-h,_-v,T-S).normalize(),i)s[4].setComponents(l,f,g,b).normalize(),s[5].setComponents(c-l,d-f,_-g,T-b).normalize();else if(s[4].setComponents(c-l,d-f,_-g,T-b).normalize(),t===ki)s[5].setComponents(c+l,d+f,_+g,T+b).normalize();else if(t===ia)s[5].setComponents(l,f,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Yr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Yr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Yr)}intersectsSprite(e){Yr.center.set(0,0,0);let t=WM.distanceTo(e.center);return Yr.radius=.7071067811865476+t,Yr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Yr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Zc.x=s.normal.x>0?e.max.x:e.min.x,Zc.y=s.normal.y>0?e.max.y:e.min.y,Zc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Zc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},g_=new gt,xu=class n{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];g_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new yr),i[s].setFromProjectionMatrix(g_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new yr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ua=class extends $s{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new st(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},yu=new X,vu=new X,__=new gt,il=new ca,Kc=new Xs,Rd=new X,x_=new X,bu=class extends Hn{constructor(e=new Qn,t=new ua){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)yu.fromBufferAttribute(t,s-1),vu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=yu.distanceTo(vu);e.setAttribute("lineDistance",new Cn(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Kc.copy(i.boundingSphere),Kc.applyMatrix4(s),Kc.radius+=r,e.ray.intersectsSphere(Kc)===!1)return;__.copy(s).invert(),il.copy(e.ray).applyMatrix4(__);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),y=Math.min(u.count,o.start+o.count);for(let v=d,g=y-1;v<g;v+=c){let _=u.getX(v),m=u.getX(v+1),S=Qc(this,e,il,l,_,m,v);S&&t.push(S)}if(this.isLineLoop){let v=u.getX(y-1),g=u.getX(d),_=Qc(this,e,il,l,v,g,y-1);_&&t.push(_)}}else{let d=Math.max(0,o.start),y=Math.min(f.count,o.start+o.count);for(let v=d,g=y-1;v<g;v+=c){let _=Qc(this,e,il,l,v,v+1,v);_&&t.push(_)}if(this.isLineLoop){let v=Qc(this,e,il,l,y-1,d,y-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Qc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(yu.fromBufferAttribute(a,s),vu.fromBufferAttribute(a,r),t.distanceSqToSegment(yu,vu,Rd,x_)>i)return;Rd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Rd);if(!(c<e.near||c>e.far))return{distance:c,point:x_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var y_=new X,v_=new X,xl=class extends bu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)y_.fromBufferAttribute(t,s),v_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+y_.distanceTo(v_);e.setAttribute("lineDistance",new Cn(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var yl=class extends fi{constructor(e=[],t=to,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Js=class extends fi{constructor(e,t,i=is,s,r,o,a=Bn,l=Bn,c,u=Hs,h=1){if(u!==Hs&&u!==Zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new oa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},vl=class extends Js{constructor(e,t=is,i=to,s,r,o=Bn,a=Bn,l,c=Hs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},bl=class extends fi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ha=class n extends Qn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;y("z","y","x",-1,-1,i,t,e,o,r,0),y("z","y","x",1,-1,i,t,-e,o,r,1),y("x","z","y",1,1,e,i,t,s,o,2),y("x","z","y",1,-1,e,i,-t,s,o,3),y("x","y","z",1,-1,e,t,i,s,r,4),y("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(u,3)),this.setAttribute("uv",new Cn(h,2));function y(v,g,_,m,S,b,T,M,p,w,L){let P=b/p,N=T/w,I=b/2,U=T/2,D=M/2,V=p+1,Y=w+1,W=0,ae=0,G=new X;for(let j=0;j<Y;j++){let te=j*N-U;for(let ue=0;ue<V;ue++){let K=ue*P-I;G[v]=K*m,G[g]=te*S,G[_]=D,c.push(G.x,G.y,G.z),G[v]=0,G[g]=0,G[_]=M>0?1:-1,u.push(G.x,G.y,G.z),h.push(ue/p),h.push(1-j/w),W+=1}}for(let j=0;j<w;j++)for(let te=0;te<p;te++){let ue=f+te+V*j,K=f+te+V*(j+1),q=f+(te+1)+V*(j+1),le=f+(te+1)+V*j;l.push(ue,K,le),l.push(K,q,le),ae+=6}a.addGroup(d,ae,L),d+=ae,f+=W}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Sl=class n extends Qn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],y=[],v=[],g=[];for(let _=0;_<u;_++){let m=_*f-o;for(let S=0;S<c;S++){let b=S*h-r;y.push(b,-m,0),v.push(0,0,1),g.push(S/a),g.push(1-_/l)}}for(let _=0;_<l;_++)for(let m=0;m<a;m++){let S=m+c*_,b=m+c*(_+1),T=m+1+c*(_+1),M=m+1+c*_;d.push(S,b,M),d.push(b,T,M)}this.setIndex(d),this.setAttribute("position",new Cn(y,3)),this.setAttribute("normal",new Cn(v,3)),this.setAttribute("uv",new Cn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var vr=class n extends Qn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new X,f=new X,d=[],y=[],v=[],g=[];for(let _=0;_<=i;_++){let m=[],S=_/i,b=o+S*a,T=e*Math.cos(b),M=Math.sqrt(e*e-T*T),p=0;_===0&&o===0?p=.5/t:_===i&&l===Math.PI&&(p=-.5/t);for(let w=0;w<=t;w++){let L=w/t,P=s+L*r;h.x=-M*Math.cos(P),h.y=T,h.z=M*Math.sin(P),y.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),g.push(L+p,1-S),m.push(c++)}u.push(m)}for(let _=0;_<i;_++)for(let m=0;m<t;m++){let S=u[_][m+1],b=u[_][m],T=u[_+1][m],M=u[_+1][m+1];(_!==0||o>0)&&d.push(S,b,M),(_!==i-1||l<Math.PI)&&d.push(b,T,M)}this.setIndex(d),this.setAttribute("position",new Cn(y,3)),this.setAttribute("normal",new Cn(v,3)),this.setAttribute("uv",new Cn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function io(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(b_(s))s.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(b_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ei(n){let e={};for(let t=0;t<n.length;t++){let i=io(n[t]);for(let s in i)e[s]=i[s]}return e}function b_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function XM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function mp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var _x={clone:io,merge:ei},$M=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,qM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends $s{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=$M,this.fragmentShader=qM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=io(e.uniforms),this.uniformsGroups=XM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new st().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new kt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new gt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Su=class extends zi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ml=class extends $s{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new st(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new st(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Mh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ws,this.combine=Fu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Mu=class extends $s{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=tx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},wu=class extends $s{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ko(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function eu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var br=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Tu=class extends br{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ld,endingEnd:Ld}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nd:r=e,a=2*t-i;break;case Dd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Nd:o=e,l=2*i-t;break;case Dd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,y=(i-t)/(s-t),v=y*y,g=v*y,_=-f*g+2*f*v-f*y,m=(1+f)*g+(-1.5-2*f)*v+(-.5+f)*y+1,S=(-1-d)*g+(1.5+d)*v+.5*y,b=d*g-d*v;for(let T=0;T!==a;++T)r[T]=_*o[u+T]+m*o[c+T]+S*o[l+T]+b*o[h+T];return r}},Au=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Eu=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Cu=class extends br{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let y=(i-t)/(s-t),v=1-y;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*y;return r}let f=a*2,d=e-1;for(let y=0;y!==a;++y){let v=o[c+y],g=o[l+y],_=d*f+y*2,m=h[_],S=h[_+1],b=e*f+y*2,T=u[b],M=u[b+1],p=JM(i,t,m,T,s);r[y]=xx(p,v,S,M,g)}return r}};function xx(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function YM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function JM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=xx(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=YM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Pi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ko(t,this.TimeBufferType),this.values=Ko(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ko(e.times,Array),values:Ko(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),eu(e.settings)&&(i.settings={inTangents:Ko(e.settings.inTangents,Array),outTangents:Ko(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Eu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Tu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Cu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case al:t=this.InterpolantFactoryMethodDiscrete;break;case pu:t=this.InterpolantFactoryMethodLinear;break;case iu:t=this.InterpolantFactoryMethodSmooth;break;case Id:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return al;case this.InterpolantFactoryMethodLinear:return pu;case this.InterpolantFactoryMethodSmooth:return iu;case this.InterpolantFactoryMethodBezier:return Id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;eu(this.settings)&&(S_(this.settings.inTangents,e),S_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;eu(this.settings)&&(M_(this.settings.inTangents,e),M_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&uM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===iu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let y=0;y!==i;++y){let v=t[h+y];if(v!==t[f+y]||v!==t[d+y]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,eu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function S_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function M_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Pi.prototype.ValueTypeName="";Pi.prototype.TimeBufferType=Float32Array;Pi.prototype.ValueBufferType=Float32Array;Pi.prototype.DefaultInterpolation=pu;var Sr=class extends Pi{constructor(e,t,i){super(e,t,i)}};Sr.prototype.ValueTypeName="bool";Sr.prototype.ValueBufferType=Array;Sr.prototype.DefaultInterpolation=al;Sr.prototype.InterpolantFactoryMethodLinear=void 0;Sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Ru=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Ru.prototype.ValueTypeName="color";var Pu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Pu.prototype.ValueTypeName="number";var Iu=class extends br{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},wl=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Iu(this.times,this.values,this.getValueSize(),e)}};wl.prototype.ValueTypeName="quaternion";wl.prototype.InterpolantFactoryMethodSmooth=void 0;var Mr=class extends Pi{constructor(e,t,i){super(e,t,i)}};Mr.prototype.ValueTypeName="string";Mr.prototype.ValueBufferType=Array;Mr.prototype.DefaultInterpolation=al;Mr.prototype.InterpolantFactoryMethodLinear=void 0;Mr.prototype.InterpolantFactoryMethodSmooth=void 0;var Lu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Lu.prototype.ValueTypeName="vector";var Od={enabled:!1,files:{},add:function(n,e){this.enabled!==!1&&(w_(n)||(this.files[n]=e))},get:function(n){if(this.enabled!==!1&&!w_(n))return this.files[n]},remove:function(n){delete this.files[n]},clear:function(){this.files={}}};function w_(n){try{let e=n.slice(n.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Nu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],y=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return y}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},yx=new Nu,Zr=class{constructor(e){this.manager=e!==void 0?e:yx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Zr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Vs={},Fd=class extends Error{constructor(e,t){super(e),this.response=t}},Tl=class extends Zr{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,i,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Od.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Vs[e]!==void 0){Vs[e].push({onLoad:t,onProgress:i,onError:s});return}Vs[e]=[],Vs[e].push({onLoad:t,onProgress:i,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Ye("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Vs[e],h=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),d=f?parseInt(f):0,y=d!==0,v=0,g=new ReadableStream({start(_){m();function m(){h.read().then(({done:S,value:b})=>{if(S)_.close();else{v+=b.byteLength;let T=new ProgressEvent("progress",{lengthComputable:y,loaded:v,total:d});for(let M=0,p=u.length;M<p;M++){let w=u[M];w.onProgress&&w.onProgress(T)}_.enqueue(b),m()}},S=>{_.error(S)})}}});return new Response(g)}else throw new Fd(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),f=h&&h[1]?h[1].toLowerCase():void 0,d=new TextDecoder(f);return c.arrayBuffer().then(y=>d.decode(y))}}}).then(c=>{Od.add(`file:${e}`,c);let u=Vs[e];delete Vs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onLoad&&d.onLoad(c)}}).catch(c=>{let u=Vs[e];if(u===void 0)throw this.manager.itemError(e),c;delete Vs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onError&&d.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Al=class extends Hn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new st(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},El=class extends Al{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Hn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new st(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Pd=new gt,T_=new X,A_=new X,Du=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=pi,this.map=null,this.mapPass=null,this.matrix=new gt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new yr,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new kt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;T_.setFromMatrixPosition(e.matrixWorld),t.position.copy(T_),A_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(A_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Pd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Pd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ia||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Pd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},tu=new X,nu=new Sn,_s=new X,Cl=class extends Hn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new gt,this.projectionMatrix=new gt,this.projectionMatrixInverse=new gt,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(tu,nu,_s),_s.x===1&&_s.y===1&&_s.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tu,nu,_s.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(tu,nu,_s),_s.x===1&&_s.y===1&&_s.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tu,nu,_s.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},_r=new X,E_=new Ke,C_=new Ke,Ci=class extends Cl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ra*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(rl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ra*2*Math.atan(Math.tan(rl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){_r.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(_r.x,_r.y).multiplyScalar(-e/_r.z),_r.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(_r.x,_r.y).multiplyScalar(-e/_r.z)}getViewSize(e,t){return this.getViewBounds(e,E_,C_),t.subVectors(C_,E_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(rl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ii=class extends Cl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ud=class extends Du{constructor(){super(new Ii(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Rl=class extends Al{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Hn.DEFAULT_UP),this.updateMatrix(),this.target=new Hn,this.shadow=new Ud}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Qo=-90,ea=1,fa=class extends Hn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ci(Qo,ea,e,t);s.layers=this.layers,this.add(s);let r=new Ci(Qo,ea,e,t);r.layers=this.layers,this.add(r);let o=new Ci(Qo,ea,e,t);o.layers=this.layers,this.add(o);let a=new Ci(Qo,ea,e,t);a.layers=this.layers,this.add(a);let l=new Ci(Qo,ea,e,t);l.layers=this.layers,this.add(l);let c=new Ci(Qo,ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ia)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),y=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=y,i.texture.needsPMREMUpdate=!0}},Ou=class extends Ci{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var gp="\\[\\]\\.:\\/",jM=new RegExp("["+gp+"]","g"),_p="[^"+gp+"]",ZM="[^"+gp.replace("\\.","")+"]",KM=/((?:WC+[\/:])*)/.source.replace("WC",_p),QM=/(WCOD+)?/.source.replace("WCOD",ZM),ew=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_p),tw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_p),nw=new RegExp("^"+KM+QM+ew+tw+"$"),iw=["material","materials","bones","map"],Bd=class{constructor(e,t,i){let s=i||Qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(jM,"")}static parseTrackName(e){let t=nw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);iw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Qt.Composite=Bd;Qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Qt.prototype.GetterByBindingType=[Qt.prototype._getValue_direct,Qt.prototype._getValue_array,Qt.prototype._getValue_arrayElement,Qt.prototype._getValue_toArray];Qt.prototype.SetterByBindingTypeAndVersioning=[[Qt.prototype._setValue_direct,Qt.prototype._setValue_direct_setNeedsUpdate,Qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_array,Qt.prototype._setValue_array_setNeedsUpdate,Qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_arrayElement,Qt.prototype._setValue_arrayElement_setNeedsUpdate,Qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_fromArray,Qt.prototype._setValue_fromArray_setNeedsUpdate,Qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var m2=new Float32Array(1);var R_=new gt,Kr=class{constructor(e,t,i=0,s=1/0){this.ray=new ca(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new aa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):tt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return R_.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(R_),this}intersectObject(e,t=!0,i=[]){return kd(e,this,i,t),i.sort(P_),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)kd(e[s],this,i,t);return i.sort(P_),i}};function P_(n,e){return n.distance-e.distance}function kd(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)kd(r[o],e,t,!0)}}var zd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Pl=class extends ts{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function xp(n,e,t,i){let s=sw(i);switch(t){case rp:return n*e;case Hu:return n*e/s.components*s.byteLength;case Wu:return n*e/s.components*s.byteLength;case Ar:return n*e*2/s.components*s.byteLength;case Xu:return n*e*2/s.components*s.byteLength;case op:return n*e*3/s.components*s.byteLength;case rs:return n*e*4/s.components*s.byteLength;case $u:return n*e*4/s.components*s.byteLength;case Nl:case Dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ol:case Fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Yu:case ju:return Math.max(n,16)*Math.max(e,8)/4;case qu:case Ju:return Math.max(n,8)*Math.max(e,8)/2;case Zu:case Ku:case eh:case th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Qu:case Ul:case nh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case oh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case lh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case hh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case mh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case gh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case _h:case xh:case yh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case vh:case bh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Bl:case Sh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function sw(n){switch(n){case pi:case tp:return{byteLength:1,components:1};case ga:case np:case ss:return{byteLength:2,components:1};case Vu:case Gu:return{byteLength:2,components:4};case is:case zu:case Vi:return{byteLength:4,components:1};case ip:case sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Vx(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function ow(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,y)=>d.start-y.start);let f=0;for(let d=1;d<h.length;d++){let y=h[f],v=h[d];v.start<=y.start+y.count+1?y.count=Math.max(y.count,v.start+v.count-y.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,y=h.length;d<y;d++){let v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var aw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,lw=`#ifdef USE_ALPHAHASH
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
#endif`,cw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,uw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,fw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,dw=`#ifdef USE_AOMAP
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
#endif`,pw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,mw=`#ifdef USE_BATCHING
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
#endif`,gw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_w=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,xw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,yw=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,vw=`#ifdef USE_IRIDESCENCE
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
#endif`,bw=`#ifdef USE_BUMPMAP
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
#endif`,Sw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Mw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ww=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Tw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Aw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Rw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Pw=`#define PI 3.141592653589793
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
} // validated`,Iw=`vec3 transformedNormal = objectNormal;
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
#endif`,Lw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Nw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Dw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ow=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Fw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Uw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Bw=`#ifdef USE_ENVMAP
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
#endif`,kw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zw=`#ifdef USE_ENVMAP
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
#endif`,Vw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Gw=`#ifdef USE_ENVMAP
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
#endif`,Hw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ww=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$w=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,qw=`#ifdef USE_GRADIENTMAP
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
}`,Yw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Jw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,jw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Zw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Kw=`#ifdef USE_ENVMAP
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
#endif`,Qw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,e1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,t1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,n1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,i1=`PhysicalMaterial material;
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
#endif`,s1=`uniform sampler2D dfgLUT;
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
}`,r1=`
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
#endif`,o1=`#if defined( RE_IndirectDiffuse )
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
#endif`,a1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,l1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,c1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,u1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,h1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,f1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,d1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,p1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,m1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,g1=`#if defined( USE_POINTS_UV )
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
#endif`,_1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,x1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,y1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,v1=`#if defined( USE_MORPHCOLORS )
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
#endif`,b1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,S1=`#ifdef USE_MORPHTARGETS
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
#endif`,M1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,w1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,T1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,A1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,E1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,C1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,R1=`#ifdef USE_NORMALMAP
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
#endif`,P1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,I1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,L1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,N1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,D1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,O1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,F1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,U1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,B1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,k1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,z1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,V1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,G1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,H1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,W1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,X1=`float getShadowMask() {
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
}`,$1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,q1=`#ifdef USE_SKINNING
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
#endif`,Y1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,J1=`#ifdef USE_SKINNING
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
#endif`,j1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Z1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,K1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Q1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,eT=`#ifdef USE_TRANSMISSION
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
#endif`,tT=`#ifdef USE_TRANSMISSION
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
#endif`,nT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,oT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,aT=`uniform sampler2D t2D;
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
}`,lT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cT=`uniform float backgroundBlurriness;
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
}`,uT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fT=`#include <common>
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
}`,dT=`#if DEPTH_PACKING == 3200
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
}`,pT=`#define DISTANCE
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
}`,mT=`#define DISTANCE
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
}`,gT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_T=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xT=`uniform float scale;
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
}`,yT=`uniform vec3 diffuse;
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
}`,vT=`#include <common>
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
}`,bT=`uniform vec3 diffuse;
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
}`,ST=`#define LAMBERT
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
}`,MT=`#define LAMBERT
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
}`,wT=`#define MATCAP
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
}`,TT=`#define MATCAP
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
}`,AT=`#define NORMAL
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
}`,ET=`#define NORMAL
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
}`,CT=`#define PHONG
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
}`,RT=`#define PHONG
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
}`,PT=`#define STANDARD
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
}`,IT=`#define STANDARD
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
}`,LT=`#define TOON
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
}`,NT=`#define TOON
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
}`,DT=`uniform float size;
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
}`,OT=`uniform vec3 diffuse;
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
}`,FT=`#include <common>
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
}`,UT=`uniform vec3 color;
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
}`,BT=`uniform float rotation;
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
}`,kT=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:aw,alphahash_pars_fragment:lw,alphamap_fragment:cw,alphamap_pars_fragment:uw,alphatest_fragment:hw,alphatest_pars_fragment:fw,aomap_fragment:dw,aomap_pars_fragment:pw,batching_pars_vertex:mw,batching_vertex:gw,begin_vertex:_w,beginnormal_vertex:xw,bsdfs:yw,iridescence_fragment:vw,bumpmap_pars_fragment:bw,clipping_planes_fragment:Sw,clipping_planes_pars_fragment:Mw,clipping_planes_pars_vertex:ww,clipping_planes_vertex:Tw,color_fragment:Aw,color_pars_fragment:Ew,color_pars_vertex:Cw,color_vertex:Rw,common:Pw,defaultnormal_vertex:Iw,displacementmap_pars_vertex:Lw,displacementmap_vertex:Nw,emissivemap_fragment:Dw,emissivemap_pars_fragment:Ow,colorspace_fragment:Fw,colorspace_pars_fragment:Uw,envmap_fragment:Bw,envmap_common_pars_fragment:kw,envmap_pars_fragment:zw,envmap_pars_vertex:Vw,envmap_physical_pars_fragment:Kw,envmap_vertex:Gw,fog_vertex:Hw,fog_pars_vertex:Ww,fog_fragment:Xw,fog_pars_fragment:$w,gradientmap_pars_fragment:qw,lightmap_pars_fragment:Yw,lights_lambert_fragment:Jw,lights_lambert_pars_fragment:jw,lights_pars_begin:Zw,lights_toon_fragment:Qw,lights_toon_pars_fragment:e1,lights_phong_fragment:t1,lights_phong_pars_fragment:n1,lights_physical_fragment:i1,lights_physical_pars_fragment:s1,lights_fragment_begin:r1,lights_fragment_maps:o1,lights_fragment_end:a1,lightprobes_pars_fragment:l1,logdepthbuf_fragment:c1,logdepthbuf_pars_fragment:u1,logdepthbuf_pars_vertex:h1,logdepthbuf_vertex:f1,map_fragment:d1,map_pars_fragment:p1,map_particle_fragment:m1,map_particle_pars_fragment:g1,metalnessmap_fragment:_1,metalnessmap_pars_fragment:x1,morphinstance_vertex:y1,morphcolor_vertex:v1,morphnormal_vertex:b1,morphtarget_pars_vertex:S1,morphtarget_vertex:M1,normal_fragment_begin:w1,normal_fragment_maps:T1,normal_pars_fragment:A1,normal_pars_vertex:E1,normal_vertex:C1,normalmap_pars_fragment:R1,clearcoat_normal_fragment_begin:P1,clearcoat_normal_fragment_maps:I1,clearcoat_pars_fragment:L1,iridescence_pars_fragment:N1,opaque_fragment:D1,packing:O1,premultiplied_alpha_fragment:F1,project_vertex:U1,dithering_fragment:B1,dithering_pars_fragment:k1,roughnessmap_fragment:z1,roughnessmap_pars_fragment:V1,shadowmap_pars_fragment:G1,shadowmap_pars_vertex:H1,shadowmap_vertex:W1,shadowmask_pars_fragment:X1,skinbase_vertex:$1,skinning_pars_vertex:q1,skinning_vertex:Y1,skinnormal_vertex:J1,specularmap_fragment:j1,specularmap_pars_fragment:Z1,tonemapping_fragment:K1,tonemapping_pars_fragment:Q1,transmission_fragment:eT,transmission_pars_fragment:tT,uv_pars_fragment:nT,uv_pars_vertex:iT,uv_vertex:sT,worldpos_vertex:rT,background_vert:oT,background_frag:aT,backgroundCube_vert:lT,backgroundCube_frag:cT,cube_vert:uT,cube_frag:hT,depth_vert:fT,depth_frag:dT,distance_vert:pT,distance_frag:mT,equirect_vert:gT,equirect_frag:_T,linedashed_vert:xT,linedashed_frag:yT,meshbasic_vert:vT,meshbasic_frag:bT,meshlambert_vert:ST,meshlambert_frag:MT,meshmatcap_vert:wT,meshmatcap_frag:TT,meshnormal_vert:AT,meshnormal_frag:ET,meshphong_vert:CT,meshphong_frag:RT,meshphysical_vert:PT,meshphysical_frag:IT,meshtoon_vert:LT,meshtoon_frag:NT,points_vert:DT,points_frag:OT,shadow_vert:FT,shadow_frag:UT,sprite_vert:BT,sprite_frag:kT},De={common:{diffuse:{value:new st(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new st(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new st(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new st(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},Ms={basic:{uniforms:ei([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:ei([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new st(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:ei([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new st(0)},specular:{value:new st(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:ei([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new st(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:ei([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new st(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:ei([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:ei([De.points,De.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:ei([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:ei([De.common,De.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:ei([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:ei([De.sprite,De.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:ei([De.common,De.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:ei([De.lights,De.fog,{color:{value:new st(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};Ms.physical={uniforms:ei([Ms.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new st(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new st(0)},specularColor:{value:new st(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Th={r:0,b:0,g:0},zT=new gt,Gx=new nt;Gx.set(-1,0,0,0,1,0,0,0,1);function VT(n,e,t,i,s,r){let o=new st(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(m){let S=m.isScene===!0?m.background:null;if(S&&S.isTexture){let b=m.backgroundBlurriness>0;S=e.get(S,b)}return S}function y(m){let S=!1,b=d(m);b===null?g(o,a):b&&b.isColor&&(g(b,1),S=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(m,S){let b=d(S);b&&b.isCubeTexture?(c===void 0&&(c=new Mn(new ha(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:io(Ms.backgroundCube.uniforms),vertexShader:Ms.backgroundCube.vertexShader,fragmentShader:Ms.backgroundCube.fragmentShader,side:ui,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,M,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zT.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Gx),c.material.toneMapped=vt.getTransfer(b.colorSpace)!==It,(u!==b||h!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),c.layers.enableAll(),m.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Mn(new Sl(2,2),new zi({name:"BackgroundMaterial",uniforms:io(Ms.background.uniforms),vertexShader:Ms.background.vertexShader,fragmentShader:Ms.background.fragmentShader,side:Tr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=vt.getTransfer(b.colorSpace)!==It,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,f=n.toneMapping),l.layers.enableAll(),m.unshift(l,l.geometry,l.material,0,0,null))}function g(m,S){m.getRGB(Th,mp(n)),t.buffers.color.setClear(Th.r,Th.g,Th.b,S,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(m,S=1){o.set(m),a=S,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(m){a=m,g(o,a)},render:y,addToRenderList:v,dispose:_}}function GT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(N,I,U,D,V){let Y=!1,W=h(N,D,U,I);r!==W&&(r=W,c(r.object)),Y=d(N,D,U,V),Y&&y(N,D,U,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(N,I,U,D),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,I,U,D){let V=D.wireframe===!0,Y=i[I.id];Y===void 0&&(Y={},i[I.id]=Y);let W=N.isInstancedMesh===!0?N.id:0,ae=Y[W];ae===void 0&&(ae={},Y[W]=ae);let G=ae[U.id];G===void 0&&(G={},ae[U.id]=G);let j=G[V];return j===void 0&&(j=f(l()),G[V]=j),j}function f(N){let I=[],U=[],D=[];for(let V=0;V<t;V++)I[V]=0,U[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:I,enabledAttributes:U,attributeDivisors:D,object:N,attributes:{},index:null}}function d(N,I,U,D){let V=r.attributes,Y=I.attributes,W=0,ae=U.getAttributes();for(let G in ae)if(ae[G].location>=0){let te=V[G],ue=Y[G];if(ue===void 0&&(G==="instanceMatrix"&&N.instanceMatrix&&(ue=N.instanceMatrix),G==="instanceColor"&&N.instanceColor&&(ue=N.instanceColor)),te===void 0||te.attribute!==ue||ue&&te.data!==ue.data)return!0;W++}return r.attributesNum!==W||r.index!==D}function y(N,I,U,D){let V={},Y=I.attributes,W=0,ae=U.getAttributes();for(let G in ae)if(ae[G].location>=0){let te=Y[G];te===void 0&&(G==="instanceMatrix"&&N.instanceMatrix&&(te=N.instanceMatrix),G==="instanceColor"&&N.instanceColor&&(te=N.instanceColor));let ue={};ue.attribute=te,te&&te.data&&(ue.data=te.data),V[G]=ue,W++}r.attributes=V,r.attributesNum=W,r.index=D}function v(){let N=r.newAttributes;for(let I=0,U=N.length;I<U;I++)N[I]=0}function g(N){_(N,0)}function _(N,I){let U=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;U[N]=1,D[N]===0&&(n.enableVertexAttribArray(N),D[N]=1),V[N]!==I&&(n.vertexAttribDivisor(N,I),V[N]=I)}function m(){let N=r.newAttributes,I=r.enabledAttributes;for(let U=0,D=I.length;U<D;U++)I[U]!==N[U]&&(n.disableVertexAttribArray(U),I[U]=0)}function S(N,I,U,D,V,Y,W){W===!0?n.vertexAttribIPointer(N,I,U,V,Y):n.vertexAttribPointer(N,I,U,D,V,Y)}function b(N,I,U,D){v();let V=D.attributes,Y=U.getAttributes(),W=I.defaultAttributeValues;for(let ae in Y){let G=Y[ae];if(G.location>=0){let j=V[ae];if(j===void 0&&(ae==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),ae==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let te=j.normalized,ue=j.itemSize,K=e.get(j);if(K===void 0)continue;let q=K.buffer,le=K.type,fe=K.bytesPerElement,ge=le===n.INT||le===n.UNSIGNED_INT||j.gpuType===zu;if(j.isInterleavedBufferAttribute){let xe=j.data,Ue=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,Je=j.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let Ge=0;Ge<G.locationSize;Ge++)_(G.location+Ge,xe.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let Ge=0;Ge<G.locationSize;Ge++)g(G.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,q);for(let Ge=0;Ge<G.locationSize;Ge++)S(G.location+Ge,ue/G.locationSize,le,te,Ue*fe,(Je+ue/G.locationSize*Ge)*fe,ge)}else{if(j.isInstancedBufferAttribute){for(let xe=0;xe<G.locationSize;xe++)_(G.location+xe,j.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let xe=0;xe<G.locationSize;xe++)g(G.location+xe);n.bindBuffer(n.ARRAY_BUFFER,q);for(let xe=0;xe<G.locationSize;xe++)S(G.location+xe,ue/G.locationSize,le,te,ue*fe,ue/G.locationSize*xe*fe,ge)}}else if(W!==void 0){let te=W[ae];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(G.location,te);break;case 3:n.vertexAttrib3fv(G.location,te);break;case 4:n.vertexAttrib4fv(G.location,te);break;default:n.vertexAttrib1fv(G.location,te)}}}}m()}function T(){L();for(let N in i){let I=i[N];for(let U in I){let D=I[U];for(let V in D){let Y=D[V];for(let W in Y)u(Y[W].object),delete Y[W];delete D[V]}}delete i[N]}}function M(N){if(i[N.id]===void 0)return;let I=i[N.id];for(let U in I){let D=I[U];for(let V in D){let Y=D[V];for(let W in Y)u(Y[W].object),delete Y[W];delete D[V]}}delete i[N.id]}function p(N){for(let I in i){let U=i[I];for(let D in U){let V=U[D];if(V[N.id]===void 0)continue;let Y=V[N.id];for(let W in Y)u(Y[W].object),delete Y[W];delete V[N.id]}}}function w(N){for(let I in i){let U=i[I],D=N.isInstancedMesh===!0?N.id:0,V=U[D];if(V!==void 0){for(let Y in V){let W=V[Y];for(let ae in W)u(W[ae].object),delete W[ae];delete V[Y]}delete U[D],Object.keys(U).length===0&&delete i[I]}}}function L(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:M,releaseStatesOfObject:w,releaseStatesOfProgram:p,initAttributes:v,enableAttribute:g,disableUnusedAttributes:m}}function HT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function WT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let p=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(p){return!(p!==rs&&i.convert(p)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(p){let w=p===ss&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(p!==pi&&p!==Vi&&!w&&i.convert(p)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(p){if(p==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),_=n.getParameter(n.MAX_VERTEX_ATTRIBS),m=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:y,maxTextureSize:v,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:m,maxVaryings:S,maxFragmentUniforms:b,maxSamples:T,samples:M}}function XT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new es,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let y=h.clippingPlanes,v=h.clipIntersection,g=h.clipShadows,_=n.get(h);if(!s||y===null||y.length===0||r&&!g)r?u(null):c();else{let m=r?0:i,S=m*4,b=_.clippingState||null;l.value=b,b=u(y,f,S,d);for(let T=0;T!==S;++T)b[T]=t[T];_.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=m}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,y){let v=h!==null?h.length:0,g=null;if(v!==0){if(g=l.value,y!==!0||g===null){let _=d+v*4,m=f.matrixWorldInverse;a.getNormalMatrix(m),(g===null||g.length<_)&&(g=new Float32Array(_));for(let S=0,b=d;S!==v;++S,b+=4)o.copy(h[S]).applyMatrix4(m,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var Vl=class extends Ri{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new yl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ha(5,5,5),r=new zi({name:"CubemapFromEquirect",uniforms:io(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ui,blending:Qr});r.uniforms.tEquirect.value=t;let o=new Mn(s,r),a=t.minFilter;return t.minFilter===js&&(t.minFilter=ci),new fa(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},vx=256,$T=3,qT=20,Hx=256,Wx=16,YT=3,JT=new X,jT=new st,Eh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fa(1,10,null),this._boxMesh=new Mn(new ha(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=JT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,y=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(jT));let g=new fa(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=y,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Mx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Sx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(vx,dp(e))}_fromTexture(e,t){e.mapping===to||e.mapping===ma?this._setSize(e.image.length===0?vx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=bx(e,!1,!1),i=Math.log2(e)-$T;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=bx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===to||e.mapping===ma?(this._cubemapMaterial===null&&(this._cubemapMaterial=Mx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Sx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ZT(),this._integrationMaterial=KT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Wx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-YT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Hx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=QT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function bx(n,e,t){return new Vl(n,{minFilter:js,generateMipmaps:e,type:ss,colorSpace:ll,depthBuffer:t})}function Gl(n,e,t){return new zi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ui,blending:Qr,depthTest:!1,depthWrite:!1})}function ZT(){return Gl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Hx}u

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
	`)}function KT(){return Gl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Wx}},`

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
	`)}function QT(){return Gl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${qT}
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
	`)}function Sx(){return Gl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Mx(){return Gl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function eA(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Uu||d===Bu)if(e.has(f)){let y=e.get(f).texture;return a(y,f.mapping)}else{let y=f.image;if(y&&y.height>0){let v=new Vl(y.height);return v.fromEquirectangularTexture(n,f),e.set(f,v),f.addEventListener("dispose",c),a(v.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,y=d===Uu||d===Bu,v=d===to||d===ma;if(y||v){let g=t.get(f),_=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==_)return i===null&&(i=new Eh(n)),g=y?i.fromEquirectangular(f,g):i.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let m=f.image;return y&&m&&m.height>0||v&&m&&l(m)?(i===null&&(i=new Eh(n)),g=y?i.fromEquirectangular(f):i.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===Uu?f.mapping=to:d===Bu&&(f.mapping=ma),f}function l(f){let d=0,y=6;for(let v=0;v<y;v++)f[v]!==void 0&&d++;return d===y}function c(f){let d=f.target;d.removeEventListener("dispose",c);let y=e.get(d);y!==void 0&&(e.delete(d),y.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let y=t.get(d);y!==void 0&&(t.delete(d),y.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function tA(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&sl("WebGLRenderer: "+i+" extension not supported."),s}}}function nA(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(y=>delete s[y]);function a(y){l(y.target)}function l(y){y.index!==null&&e.remove(y.index);for(let g in y.attributes)e.remove(y.attributes[g]);y.removeEventListener("dispose",a),delete s[y.id],o.unregister(y);let v=r.get(y);v&&(e.remove(v),r.delete(y)),i.releaseStatesOfGeometry(y),y.isInstancedBufferGeometry===!0&&delete y._maxInstanceCount,t.memory.geometries--}function c(y,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(y){let v=y.attributes;for(let g in v)e.update(v[g],n.ARRAY_BUFFER)}function h(y){let v=y.index,g=y.attributes.position,_=0;if(g===void 0)return;let m=v!==null?v.array.length:g.array.length/3-1,S=g.count>=65535?jr:Jr,b=new S(Math.ceil(m/3)*6,1),T=b.array;if(v!==null){let p=v.array;_=v.version;for(let w=0,L=0;w<m;w+=3){let P=p[w+0],N=p[w+1],I=p[w+2];T[L++]=P,T[L++]=N,T[L++]=N,T[L++]=I,T[L++]=I,T[L++]=P}}else{_=g.version;for(let p=0,w=0;p<m;p+=3){let L=p+0,P=p+1,N=p+2;T[w++]=L,T[w++]=P,T[w++]=P,T[w++]=N,T[w++]=N,T[w++]=L}}b.version=_;let M=r.get(y);M&&e.remove(M),r.set(y,b)}function f(y){let v=r.get(y);if(v){let g=y.index;g!==null&&v.version<g.version&&h(y)}else h(y);return r.get(y)}function d(){for(let y in s){let v=s[y].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function iA(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let v=0;for(let g=0;g<d;g++)v+=f[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function sA(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function rA(n,e,t){let i=new WeakMap,s=new kt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let L=function(){p.dispose(),i.delete(a),a.removeEventListener("dispose",L)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,y=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],m=a.morphAttributes.color||[],S=0;d===!0&&(S=1),y===!0&&(S=2),v===!0&&(S=3);let b=a.attributes.position.count*S,T=1;b>e.maxTextureSize&&(T=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let M=new Float32Array(b*T*4*h),p=new hl(M,b,T,h);p.type=Vi,p.needsUpdate=!0;let w=S*4;for(let P=0;P<h;P++){let N=g[P],I=_[P],U=m[P],D=b*T*4*P;for(let V=0;V<N.count;V++){let Y=V*w;d===!0&&(s.fromBufferAttribute(N,V),M[D+Y+0]=s.x,M[D+Y+1]=s.y,M[D+Y+2]=s.z,M[D+Y+3]=0),y===!0&&(s.fromBufferAttribute(I,V),M[D+Y+4]=s.x,M[D+Y+5]=s.y,M[D+Y+6]=s.z,M[D+Y+7]=0),v===!0&&(s.fromBufferAttribute(U,V),M[D+Y+8]=s.x,M[D+Y+9]=s.y,M[D+Y+10]=s.z,M[D+Y+11]=U.itemSize===4?s.w:1)}}f={count:h,texture:p,size:new Ke(b,T)},i.set(a,f),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let y=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",y),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function oA(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var aA={[qd]:"LINEAR_TONE_MAPPING",[Yd]:"REINHARD_TONE_MAPPING",[Jd]:"CINEON_TONE_MAPPING",[jd]:"ACES_FILMIC_TONE_MAPPING",[Kd]:"AGX_TONE_MAPPING",[Qd]:"NEUTRAL_TONE_MAPPING",[Zd]:"CUSTOM_TONE_MAPPING"};function lA(n,e,t,i,s,r){let o=new Ri(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Qn;u.setAttribute("position",new Cn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Cn([0,2,0,0,2,0],2));let h=new Su({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Mn(u,h),d=new Ii(-1,1,1,-1,0,1),y=null,v=null,g=!1,_,m=null,S=[],b=!1;this.setSize=function(T,M){o.setSize(T,M),a!==null&&a.setSize(T,M),l!==null&&l.setSize(T,M);for(let p=0;p<S.length;p++){let w=S[p];w.setSize&&w.setSize(T,M)}},this.setEffects=function(T){S=T,b=S.length>0&&S[0].isRenderPass===!0;let M=o.width,p=o.height;S.length>0&&a===null&&(a=new Ri(M,p,{type:ss,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(M,p,{type:ss,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&S.some(L=>L.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Js(M,p),r===!0&&(c.format=Zs,c.type=no)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let L=0;L<S.length;L++){let P=S[L];P.setSize&&P.setSize(M,p),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,M){if(g||T.toneMapping===bs&&S.length===0)return!1;if(m=M,M!==null){let p=M.width,w=M.height;(o.width!==p||o.height!==w)&&this.setSize(p,w)}return b===!1&&T.setRenderTarget(o),_=T.toneMapping,T.toneMapping=bs,!0},this.hasRenderPass=function(){return b},this.end=function(T,M){T.toneMapping=_,g=!0;let p=o,w=a;for(let L=0;L<S.length;L++){let P=S[L];P.enabled!==!1&&(P.render(T,w,p,M),P.needsSwap!==!1&&(p=w,w=w===a?l:a))}if(y!==T.outputColorSpace||v!==T.toneMapping){y=T.outputColorSpace,v=T.toneMapping,h.defines={},vt.getTransfer(y)===It&&(h.defines.SRGB_TRANSFER="");let L=aA[v];L&&(h.defines[L]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=p.texture,T.setRenderTarget(m),T.render(f,d),m=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Xx=new fi,$x=new Js(1,1),qx=new vl(1),Yx=new hl,Jx=new _u,jx=new yl,wx=[],Tx=[],Ax=new Float32Array(16),Ex=new Float32Array(9),Cx=new Float32Array(4);function ya(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=wx[s];if(r===void 0&&(r=new Float32Array(s),wx[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Rn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Pn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Ch(n,e){let t=Tx[e];t===void 0&&(t=new Int32Array(e),Tx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function cA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function uA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2fv(this.addr,e),Pn(t,e)}}function hA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Rn(t,e))return;n.uniform3fv(this.addr,e),Pn(t,e)}}function fA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4fv(this.addr,e),Pn(t,e)}}function dA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Cx.set(i),n.uniformMatrix2fv(this.addr,!1,Cx),Pn(t,i)}}function pA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Ex.set(i),n.uniformMatrix3fv(this.addr,!1,Ex),Pn(t,i)}}function mA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Rn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Rn(t,i))return;Ax.set(i),n.uniformMatrix4fv(this.addr,!1,Ax),Pn(t,i)}}function gA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function _A(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2iv(this.addr,e),Pn(t,e)}}function xA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3iv(this.addr,e),Pn(t,e)}}function yA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4iv(this.addr,e),Pn(t,e)}}function vA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function bA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Rn(t,e))return;n.uniform2uiv(this.addr,e),Pn(t,e)}}function SA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Rn(t,e))return;n.uniform3uiv(this.addr,e),Pn(t,e)}}function MA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Rn(t,e))return;n.uniform4uiv(this.addr,e),Pn(t,e)}}function Rh(n){return n.version===0&&(n.compareFunction=cp,n.needsUpdate=!0),n}function wA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Rh($x):r=Xx,t.setTexture2D(e||r,s)}function TA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Jx,s)}function AA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Rh(qx):r=jx,t.setTextureCube(e||r,s)}function EA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Yx,s)}function CA(n){switch(n){case 5126:return cA;case 35664:return uA;case 35665:return hA;case 35666:return fA;case 35674:return dA;case 35675:return pA;case 35676:return mA;case 5124:case 35670:return gA;case 35667:case 35671:return _A;case 35668:case 35672:return xA;case 35669:case 35673:return yA;case 5125:return vA;case 36294:return bA;case 36295:return SA;case 36296:return MA;case 35678:case 36198:case 36298:case 36306:case 35682:return wA;case 35679:case 36299:case 36307:return TA;case 35680:case 36300:case 36308:case 36293:return AA;case 36289:case 36303:case 36311:case 36292:return EA}}function RA(n,e){n.uniform1fv(this.addr,e)}function PA(n,e){let t=ya(e,this.size,2);n.uniform2fv(this.addr,t)}function IA(n,e){let t=ya(e,this.size,3);n.uniform3fv(this.addr,t)}function LA(n,e){let t=ya(e,this.size,4);n.uniform4fv(this.addr,t)}function NA(n,e){let t=ya(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function DA(n,e){let t=ya(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function OA(n,e){let t=ya(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function FA(n,e){n.uniform1iv(this.addr,e)}function UA(n,e){n.uniform2iv(this.addr,e)}function BA(n,e){n.uniform3iv(this.addr,e)}function kA(n,e){n.uniform4iv(this.addr,e)}function zA(n,e){n.uniform1uiv(this.addr,e)}function VA(n,e){n.uniform2uiv(this.addr,e)}function GA(n,e){n.uniform3uiv(this.addr,e)}function HA(n,e){n.uniform4uiv(this.addr,e)}function WA(n,e,t){let i=this.cache,s=e.length,r=Ch(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Rh($x):o=Xx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function XA(n,e,t){let i=this.cache,s=e.length,r=Ch(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Jx,r[o])}function $A(n,e,t){let i=this.cache,s=e.length,r=Ch(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Rh(qx):o=jx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function qA(n,e,t){let i=this.cache,s=e.length,r=Ch(t,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Pn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Yx,r[o])}function YA(n){switch(n){case 5126:return RA;case 35664:return PA;case 35665:return IA;case 35666:return LA;case 35674:return NA;case 35675:return DA;case 35676:return OA;case 5124:case 35670:return FA;case 35667:case 35671:return UA;case 35668:case 35672:return BA;case 35669:case 35673:return kA;case 5125:return zA;case 36294:return VA;case 36295:return GA;case 36296:return HA;case 35678:case 36198:case 36298:case 36306:case 35682:return WA;case 35679:case 36299:case 36307:return XA;case 35680:case 36300:case 36308:case 36293:return $A;case 36289:case 36303:case 36311:case 36292:return qA}}var bp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=CA(t.type)}},Sp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=YA(t.type)}},Mp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},yp=/(\w+)(\])?(\[|\.)?/g;function Rx(n,e){n.seq.push(e),n.map[e.id]=e}function JA(n,e,t){let i=n.name,s=i.length;for(yp.lastIndex=0;;){let r=yp.exec(i),o=yp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Rx(t,c===void 0?new bp(a,n,e):new Sp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Mp(a),Rx(t,h)),t=h}}}var xa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);JA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Px(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var jA=37297,ZA=0;function KA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Ix=new nt;function QA(n){vt._getMatrix(Ix,vt.workingColorSpace,n);let e=`mat3( ${Ix.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case cl:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Lx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+KA(n.getShaderSource(e),a)}else return r}function eE(n,e){let t=QA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var tE={[qd]:"Linear",[Yd]:"Reinhard",[Jd]:"Cineon",[jd]:"ACESFilmic",[Kd]:"AgX",[Qd]:"Neutral",[Zd]:"Custom"};function nE(n,e){let t=tE[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new X;function iE(){vt.getLuminanceCoefficients(Ah);let n=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(zl).join(`
`)}function rE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function oE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function zl(n){return n!==""}function Nx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Dx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var aE=/^[ \t]*#include +<([\w\d./]+)>/gm;function wp(n){return n.replace(aE,lE)}function lE(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wp(t)}var cE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ox(n){return n.replace(cE,uE)}function uE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Fx(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var hE={[Il]:"SHADOWMAP_TYPE_PCF",[da]:"SHADOWMAP_TYPE_VSM"};function fE(n){return hE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var dE={[ma]:"ENVMAP_MODE_REFRACTION"};function pE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":dE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mE={[Fu]:"ENVMAP_BLENDING_MULTIPLY",[K_]:"ENVMAP_BLENDING_MIX",[Q_]:"ENVMAP_BLENDING_ADD"};function gE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":mE[n.combine]||"ENVMAP_BLENDING_NONE"}function _E(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=fE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=pE(t),h=gE(t),f=sE(t),d=rE(r),y=s.createProgram(),v,g,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(zl).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(zl).join(`
`),g.length>0&&(g+=`
`)):(v=[Fx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(zl).join(`
`),g=[Fx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==bs?"#define TONE_MAPPING":"",t.toneMapping!==bs?ht.tonemapping_pars_fragment:"",t.toneMapping!==bs?nE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,eE("linearToOutputTexel",t.outputColorSpace),iE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(zl).join(`
`)),o=wp(o),o=Nx(o,t),o=Dx(o,t),a=wp(a),a=Nx(a,t),a=Dx(a,t),o=Ox(o),a=Ox(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,v=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===up?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===up?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let m=_+v+o,S=_+g+a,b=Px(s,s.VERTEX_SHADER,m),T=Px(s,s.FRAGMENT_SHADER,S);s.attachShader(y,b),s.attachShader(y,T),t.index0AttributeName!==void 0?s.bindAttribLocation(y,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function M(P){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(y)||"",I=s.getShaderInfoLog(b)||"",U=s.getShaderInfoLog(T)||"",D=N.trim(),V=I.trim(),Y=U.trim(),W=!0,ae=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,y,b,T);else{let G=Lx(s,b,"vertex"),j=Lx(s,T,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+D+`
`+G+`
`+j)}else D!==""?Ye("WebGLProgram: Program Info Log:",D):(V===""||Y==="")&&(ae=!1);ae&&(P.diagnostics={runnable:W,programLog:D,vertexShader:{log:V,prefix:v},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(b),s.deleteShader(T),p=new xa(s,y),w=oE(s,y)}let p;this.getUniforms=function(){return p===void 0&&M(this),p};let w;this.getAttributes=function(){return w===void 0&&M(this),w};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(y,jA)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=ZA++,this.cacheKey=e,this.usedTimes=1,this.program=y,this.vertexShader=b,this.fragmentShader=T,this}var xE=0,Tp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ap(e),t.set(e,i)),i}},Ap=class{constructor(e){this.id=xE++,this.code=e,this.usedTimes=0}};function yE(n){return n===Ar||n===Ul||n===Bl}function vE(n,e,t,i,s,r){let o=new aa,a=new Tp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(p){return l.add(p),p===0?"uv":`uv${p}`}function y(p,w,L,P,N,I){let U=P.fog,D=N.geometry,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?P.environment:null,Y=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,W=e.get(p.envMap||V,Y),ae=f[p.type],G=i.precision;p.precision!==null&&(G=i.getMaxPrecision(p.precision),G!==p.precision&&Ye("WebGLProgram.getParameters:",p.precision,"not supported, using",G,"instead."));let j=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,te=j!==void 0?j.length:0,ue=0;D.morphAttributes.position!==void 0&&(ue=1),D.morphAttributes.normal!==void 0&&(ue=2),D.morphAttributes.color!==void 0&&(ue=3);let K,q,le,fe;if(ae){let Pe=Ms[ae];K=Pe.vertexShader,q=Pe.fragmentShader}else{K=p.vertexShader,q=p.fragmentShader;let Pe=a.getVertexShaderStage(p),lt=a.getFragmentShaderStage(p);a.update(p,Pe,lt),le=Pe.id,fe=lt.id}let ge=n.getRenderTarget(),xe=n.state.buffers.depth.getReversed(),Ue=N.isInstancedMesh===!0,Je=N.isBatchedMesh===!0,Ge=!!p.map,ft=!!p.matcap,ct=!!W,rt=ct&&W.isPMREMTexture===!0,en=!!p.aoMap,Wt=!!p.lightMap,dn=!!p.bumpMap&&p.wireframe===!1,Ut=!!p.normalMap,In=!!p.displacementMap,St=!!p.emissiveMap,wn=!!p.metalnessMap,rn=!!p.roughnessMap,pn=p.anisotropy>0,z=p.clearcoat>0,Ie=p.diffuseRoughness>0,je=p.dispersion>0,at=p.retroreflectivity>0,Te=p.iridescence>0,zt=p.sheen>0,We=p.transmission>0,qe=pn&&!!p.anisotropyMap,O=z&&!!p.clearcoatMap,E=z&&!!p.clearcoatNormalMap,J=z&&!!p.clearcoatRoughnessMap,me=Ie&&!!p.diffuseRoughnessMap,ce=Te&&!!p.iridescenceMap,be=Te&&!!p.iridescenceThicknessMap,Se=zt&&!!p.sheenColorMap,ie=zt&&!!p.sheenRoughnessMap,re=!!p.specularMap,ye=!!p.specularColorMap,k=!!p.specularIntensityMap,oe=We&&!!p.transmissionMap,se=We&&!!p.thicknessMap,Ae=!!p.gradientMap,ve=!!p.alphaMap,we=p.alphaTest>0,Xe=!!p.alphaHash,Qe=!!p.extensions,de=bs;p.toneMapped&&(ge===null||ge.isXRRenderTarget===!0)&&(de=n.toneMapping);let ze=rt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,et={shaderID:ae,shaderType:p.type,shaderName:p.name,vertexShader:K,fragmentShader:q,defines:p.defines,customVertexShaderID:le,customFragmentShaderID:fe,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:G,batching:Je,batchingColor:Je&&N._colorsTexture!==null,instancing:Ue,instancingColor:Ue&&N.instanceColor!==null,instancingMorph:Ue&&N.morphTexture!==null,outputColorSpace:ge===null?n.outputColorSpace:ge.isXRRenderTarget===!0?ge.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:Ge,matcap:ft,envMap:ct,envMapMode:ct&&W.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:en,lightMap:Wt,bumpMap:dn,normalMap:Ut,displacementMap:In,emissiveMap:St,normalMapObjectSpace:Ut&&p.normalMapType===nx,normalMapTangentSpace:Ut&&p.normalMapType===Mh,packedNormalMap:Ut&&p.normalMapType===Mh&&yE(p.normalMap.format),metalnessMap:wn,roughnessMap:rn,anisotropy:pn,anisotropyMap:qe,clearcoat:z,clearcoatMap:O,clearcoatNormalMap:E,clearcoatRoughnessMap:J,diffuseRoughness:Ie,diffuseRoughnessMap:me,dispersion:je,retroreflection:at,iridescence:Te,iridescenceMap:ce,iridescenceThicknessMap:be,sheen:zt,sheenColorMap:Se,sheenRoughnessMap:ie,specularMap:re,specularColorMap:ye,specularIntensityMap:k,transmission:We,transmissionMap:oe,thicknessMap:se,gradientMap:Ae,opaque:p.transparent===!1&&p.blending===pa&&p.alphaToCoverage===!1,alphaMap:ve,alphaTest:we,alphaHash:Xe,combine:p.combine,mapUv:Ge&&d(p.map.channel),aoMapUv:en&&d(p.aoMap.channel),lightMapUv:Wt&&d(p.lightMap.channel),bumpMapUv:dn&&d(p.bumpMap.channel),normalMapUv:Ut&&d(p.normalMap.channel),displacementMapUv:In&&d(p.displacementMap.channel),emissiveMapUv:St&&d(p.emissiveMap.channel),metalnessMapUv:wn&&d(p.metalnessMap.channel),roughnessMapUv:rn&&d(p.roughnessMap.channel),anisotropyMapUv:qe&&d(p.anisotropyMap.channel),clearcoatMapUv:O&&d(p.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&d(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:me&&d(p.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&d(p.iridescenceMap.channel),iridescenceThicknessMapUv:be&&d(p.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&d(p.sheenColorMap.channel),sheenRoughnessMapUv:ie&&d(p.sheenRoughnessMap.channel),specularMapUv:re&&d(p.specularMap.channel),specularColorMapUv:ye&&d(p.specularColorMap.channel),specularIntensityMapUv:k&&d(p.specularIntensityMap.channel),transmissionMapUv:oe&&d(p.transmissionMap.channel),thicknessMapUv:se&&d(p.thicknessMap.channel),alphaMapUv:ve&&d(p.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ut||pn),vertexNormals:!!D.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!D.attributes.uv&&(Ge||ve),fog:!!U,useFog:p.fog===!0,fogExp2:!!U&&U.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||D.attributes.normal===void 0&&Ut===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:xe,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ue,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:I.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:p.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:de,decodeVideoTexture:Ge&&p.map.isVideoTexture===!0&&vt.getTransfer(p.map.colorSpace)===It,decodeVideoTextureEmissive:St&&p.emissiveMap.isVideoTexture===!0&&vt.getTransfer(p.emissiveMap.colorSpace)===It,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===di,flipSided:p.side===ui,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:Qe&&p.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&p.extensions.multiDraw===!0||Je)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function v(p){let w=[];if(p.shaderID?w.push(p.shaderID):(w.push(p.customVertexShaderID),w.push(p.customFragmentShaderID)),p.defines!==void 0)for(let L in p.defines)w.push(L),w.push(p.defines[L]);return p.isRawShaderMaterial===!1&&(g(w,p),_(w,p),w.push(n.outputColorSpace)),w.push(p.customProgramCacheKey),w.join()}function g(p,w){p.push(w.precision),p.push(w.outputColorSpace),p.push(w.envMapMode),p.push(w.envMapPMREM),p.push(w.envMapMaxLod),p.push(w.envMapSize),p.push(w.mapUv),p.push(w.alphaMapUv),p.push(w.lightMapUv),p.push(w.aoMapUv),p.push(w.bumpMapUv),p.push(w.normalMapUv),p.push(w.displacementMapUv),p.push(w.emissiveMapUv),p.push(w.metalnessMapUv),p.push(w.roughnessMapUv),p.push(w.anisotropyMapUv),p.push(w.clearcoatMapUv),p.push(w.clearcoatNormalMapUv),p.push(w.clearcoatRoughnessMapUv),p.push(w.diffuseRoughnessMapUv),p.push(w.iridescenceMapUv),p.push(w.iridescenceThicknessMapUv),p.push(w.sheenColorMapUv),p.push(w.sheenRoughnessMapUv),p.push(w.specularMapUv),p.push(w.specularColorMapUv),p.push(w.specularIntensityMapUv),p.push(w.transmissionMapUv),p.push(w.thicknessMapUv),p.push(w.combine),p.push(w.fogExp2),p.push(w.sizeAttenuation),p.push(w.morphTargetsCount),p.push(w.numSunLights),p.push(w.numDirLights),p.push(w.numPointLights),p.push(w.numSpotLights),p.push(w.numSpotLightMaps),p.push(w.numHemiLights),p.push(w.numRectAreaLights),p.push(w.numSunLightShadows),p.push(w.numDirLightShadows),p.push(w.numPointLightShadows),p.push(w.numSpotLightShadows),p.push(w.numSpotLightShadowsWithMaps),p.push(w.numLightProbes),p.push(w.numLightProbeGrids),p.push(w.shadowMapType),p.push(w.toneMapping),p.push(w.numClippingPlanes),p.push(w.numClipIntersection),p.push(w.depthPacking)}function _(p,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),p.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),p.push(o.mask)}function m(p){let w=f[p.type],L;if(w){let P=Ms[w];L=_x.clone(P.uniforms)}else L=p.uniforms;return L}function S(p,w){let L=u.get(w);return L!==void 0?++L.usedTimes:(L=new _E(n,w,p,s),c.push(L),u.set(w,L)),L}function b(p){if(--p.usedTimes===0){let w=c.indexOf(p);c[w]=c[c.length-1],c.pop(),u.delete(p.cacheKey),p.destroy()}}function T(p){a.remove(p)}function M(){a.dispose()}return{getParameters:y,getProgramCacheKey:v,getUniforms:m,acquireProgram:S,releaseProgram:b,releaseShaderCache:T,programs:c,dispose:M}}function bE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function SE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Ux(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Bx(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,y,v,g,_){let m=n[e];return m===void 0?(m={id:f.id,object:f,geometry:d,material:y,materialVariant:o(f),groupOrder:v,renderOrder:f.renderOrder,z:g,group:_},n[e]=m):(m.id=f.id,m.object=f,m.geometry=d,m.material=y,m.materialVariant=o(f),m.groupOrder=v,m.renderOrder=f.renderOrder,m.z=g,m.group=_),e++,m}function l(f,d,y,v,g,_,m){m.reversedDepth===!0&&(g=-g);let S=a(f,d,y,v,g,_);y.transmission>0?i.push(S):y.transparent===!0?s.push(S):t.push(S)}function c(f,d,y,v,g,_){let m=a(f,d,y,v,g,_);y.transmission>0?i.unshift(m):y.transparent===!0?s.unshift(m):t.unshift(m)}function u(f,d){t.length>1&&t.sort(f||SE),i.length>1&&i.sort(d||Ux),s.length>1&&s.sort(d||Ux)}function h(){for(let f=e,d=n.length;f<d;f++){let y=n[f];if(y.id===null)break;y.id=null,y.object=null,y.geometry=null,y.material=null,y.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function ME(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Bx,n.set(i,[o])):s>=r.length?(o=new Bx,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function wE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new st};break;case"SpotLight":t={position:new X,direction:new X,color:new st,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new st,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new st,groundColor:new st};break;case"RectAreaLight":t={color:new st,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function TE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var AE=0;function EE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function CE(n){let e=new wE,t=TE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new gt,o=new gt;function a(c){let u=0,h=0,f=0;for(let I=0;I<9;I++)i.probe[I].set(0,0,0);let d=0,y=0,v=0,g=0,_=0,m=0,S=0,b=0,T=0,M=0,p=0,w=0,L=0,P=0;c.sort(EE);for(let I=0,U=c.length;I<U;I++){let D=c[I],V=D.color,Y=D.intensity,W=D.distance,ae=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ar?ae=D.shadow.map.texture:ae=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=V.r*Y,h+=V.g*Y,f+=V.b*Y;else if(D.isLightProbe){for(let G=0;G<9;G++)i.probe[G].addScaledVector(D.sh.coefficients[G],Y);P++}else if(D.isSunLight){let G=e.get(D);if(G.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,te=t.get(D);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[y]=te,i.sunShadowMap[y]=ae;let ue=j.getViewportCount();for(let K=0;K<ue;K++)i.sunShadowMatrix[v+K]=j.getMatrix(K),i.sunShadowCascade[v+K]=j._cascadeData[K];v+=ue,y++}i.sun[d]=G,d++}else if(D.isDirectionalLight){let G=e.get(D);if(G.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,te=t.get(D);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.directionalShadow[g]=te,i.directionalShadowMap[g]=ae,i.directionalShadowMatrix[g]=D.shadow.matrix,T++}i.directional[g]=G,g++}else if(D.isSpotLight){let G=e.get(D);G.position.setFromMatrixPosition(D.matrixWorld),G.color.copy(V).multiplyScalar(Y),G.distance=W,G.coneCos=Math.cos(D.angle),G.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),G.decay=D.decay,i.spot[m]=G;let j=D.shadow;if(D.map&&(i.spotLightMap[w]=D.map,w++,j.updateMatrices(D),D.castShadow&&L++),i.spotLightMatrix[m]=j.matrix,D.castShadow){let te=t.get(D);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.spotShadow[m]=te,i.spotShadowMap[m]=ae,p++}m++}else if(D.isRectAreaLight){let G=e.get(D);G.color.copy(V).multiplyScalar(Y),G.halfWidth.set(D.width*.5,0,0),G.halfHeight.set(0,D.height*.5,0),i.rectArea[S]=G,S++}else if(D.isPointLight){let G=e.get(D);if(G.color.copy(D.color).multiplyScalar(D.intensity),G.distance=D.distance,G.decay=D.decay,D.castShadow){let j=D.shadow,te=t.get(D);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,i.pointShadow[_]=te,i.pointShadowMap[_]=ae,i.pointShadowMatrix[_]=D.shadow.matrix,M++}i.point[_]=G,_++}else if(D.isHemisphereLight){let G=e.get(D);G.skyColor.copy(D.color).multiplyScalar(Y),G.groundColor.copy(D.groundColor).multiplyScalar(Y),i.hemi[b]=G,b++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let N=i.hash;(N.sunLength!==d||N.directionalLength!==g||N.pointLength!==_||N.spotLength!==m||N.rectAreaLength!==S||N.hemiLength!==b||N.numSunShadows!==y||N.numDirectionalShadows!==T||N.numPointShadows!==M||N.numSpotShadows!==p||N.numSpotMaps!==w||N.numLightProbes!==P)&&(i.sun.length=d,i.directional.length=g,i.spot.length=m,i.rectArea.length=S,i.point.length=_,i.hemi.length=b,i.sunShadow.length=y,i.sunShadowMap.length=y,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=p,i.spotShadowMap.length=p,i.spotLightMatrix.length=p+w-L,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=P,N.sunLength=d,N.directionalLength=g,N.pointLength=_,N.spotLength=m,N.rectAreaLength=S,N.hemiLength=b,N.numSunShadows=y,N.numDirectionalShadows=T,N.numPointShadows=M,N.numSpotShadows=p,N.numSpotMaps=w,N.numLightProbes=P,i.version=AE++)}function l(c,u){let h=0,f=0,d=0,y=0,v=0,g=0,_=u.matrixWorldInverse;for(let m=0,S=c.length;m<S;m++){let b=c[m];if(b.isSunLight){let T=i.sun[h];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(_),h++}else if(b.isDirectionalLight){let T=i.directional[f];T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(_),f++}else if(b.isSpotLight){let T=i.spot[y];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(_),T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(_),y++}else if(b.isRectAreaLight){let T=i.rectArea[v];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(_),o.identity(),r.copy(b.matrixWorld),r.premultiply(_),o.extractRotation(r),T.halfWidth.set(b.width*.5,0,0),T.halfHeight.set(0,b.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let T=i.point[d];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(_),d++}else if(b.isHemisphereLight){let T=i.hemi[g];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(_),g++}}}return{setup:a,setupView:l,state:i}}function kx(n){let e=new CE(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function RE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new kx(n),e.set(s,[a])):r>=o.length?(a=new kx(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var PE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,IE=`uniform sampler2D shadow_pass;
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
}`,LE=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],NE=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],zx=new gt,kl=new X,vp=new X;function DE(n,e,t){let i=new yr,s=new Ke,r=new Ke,o=new kt,a=new Mu,l=new wu,c={},u=t.maxTextureSize,h={[Tr]:ui,[ui]:Tr,[di]:di},f=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:PE,fragmentShader:IE}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let y=new Qn;y.setAttribute("position",new Ft(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Mn(y,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Il;let _=this.type;this.render=function(M,p,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===N_&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Il);let L=n.getRenderTarget(),P=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),I=n.state;I.setBlending(Qr),I.buffers.depth.getReversed()===!0?I.buffers.color.setClear(0,0,0,0):I.buffers.color.setClear(1,1,1,1),I.buffers.depth.setTest(!0),I.setScissorTest(!1);let U=_!==this.type;U&&p.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=M.length;D<V;D++){let Y=M[D],W=Y.shadow;if(W===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ae=W.getFrameExtents();s.multiply(ae),r.copy(W.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,W.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,W.mapSize.y=r.y));let G=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=G,W.map===null||U===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===da){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new Ri(s.x,s.y,{format:Ar,type:ss,minFilter:ci,magFilter:ci,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new Js(s.x,s.y,Vi),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=Hs,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Bn,W.map.depthTexture.magFilter=Bn}else Y.isPointLight?(W.map=new Vl(s.x),W.map.depthTexture=new vl(s.x,is)):(W.map=new Ri(s.x,s.y),W.map.depthTexture=new Js(s.x,s.y,is)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=Hs,this.type===Il?(W.map.depthTexture.compareFunction=G?lp:ap,W.map.depthTexture.minFilter=ci,W.map.depthTexture.magFilter=ci):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Bn,W.map.depthTexture.magFilter=Bn);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let j=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,w);let te=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:w.layers;for(let ue=0;ue<j;ue++){let K=W.getCamera(ue);if(Y.isPointLight){let q=W.camera,le=W.matrix,fe=Y.distance||q.far;fe!==q.far&&(q.far=fe,q.updateProjectionMatrix()),kl.setFromMatrixPosition(Y.matrixWorld),q.position.copy(kl),vp.copy(q.position),vp.add(LE[ue]),q.up.copy(NE[ue]),q.lookAt(vp),q.updateMatrixWorld(),le.makeTranslation(-kl.x,-kl.y,-kl.z),zx.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),W._frustum.setFromProjectionMatrix(zx,q.coordinateSystem,q.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(W.map),n.clear());let q=W.getViewport(ue);o.set(r.x*q.x,r.y*q.y,r.x*q.z,r.y*q.w),I.viewport(o)}i=W.getFrustum(ue),b(p,w,K,Y,te,this.type)}W.isPointLightShadow!==!0&&this.type===da&&m(W,w),W.needsUpdate=!1}_=this.type,g.needsUpdate=!1,n.setRenderTarget(L,P,N)};function m(M,p){let w=e.update(v);f.defines.VSM_SAMPLES!==M.blurSamples&&(f.defines.VSM_SAMPLES=M.blurSamples,d.defines.VSM_SAMPLES=M.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),M.mapPass===null?M.mapPass=new Ri(s.x,s.y,{format:Ar,type:ss}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),f.uniforms.shadow_pass.value=M.map.depthTexture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(p,null,w,f,v,null),d.uniforms.shadow_pass.value=M.mapPass.texture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(p,null,w,d,v,null)}function S(M,p,w,L){let P=null,N=w.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(N!==void 0)P=N;else if(P=w.isPointLight===!0?l:a,n.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){let I=P.uuid,U=p.uuid,D=c[I];D===void 0&&(D={},c[I]=D);let V=D[U];V===void 0&&(V=P.clone(),D[U]=V,p.addEventListener("dispose",T)),P=V}if(P.visible=p.visible,P.wireframe=p.wireframe,L===da?P.side=p.shadowSide!==null?p.shadowSide:p.side:P.side=p.shadowSide!==null?p.shadowSide:h[p.side],P.alphaMap=p.alphaMap,P.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,P.map=p.map,P.clipShadows=p.clipShadows,P.clippingPlanes=p.clippingPlanes,P.clipIntersection=p.clipIntersection,P.displacementMap=p.displacementMap,P.displacementScale=p.displacementScale,P.displacementBias=p.displacementBias,P.wireframeLinewidth=p.wireframeLinewidth,P.linewidth=p.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let I=n.properties.get(P);I.light=w}return P}function b(M,p,w,L,P,N){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&N===da)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,M.matrixWorld);let D=e.update(M),V=M.material;if(Array.isArray(V)){let Y=D.groups;for(let W=0,ae=Y.length;W<ae;W++){let G=Y[W],j=V[G.materialIndex];if(j&&j.visible){let te=S(M,j,L,N);M.onBeforeShadow(n,M,p,w,D,te,G),n.renderBufferDirect(w,null,D,te,M,G),M.onAfterShadow(n,M,p,w,D,te,G)}}}else if(V.visible){let Y=S(M,V,L,N);M.onBeforeShadow(n,M,p,w,D,Y,null),n.renderBufferDirect(w,null,D,Y,M,null),M.onAfterShadow(n,M,p,w,D,Y,null)}}let U=M.children;for(let D=0,V=U.length;D<V;D++)b(U[D],p,w,L,P,N)}function T(M){M.target.removeEventListener("dispose",T);for(let w in c){let L=c[w],P=M.target.uuid;P in L&&(L[P].dispose(),delete L[P])}}}function OE(n,e){function t(){let k=!1,oe=new kt,se=null,Ae=new kt(0,0,0,0);return{setMask:function(ve){se!==ve&&!k&&(n.colorMask(ve,ve,ve,ve),se=ve)},setLocked:function(ve){k=ve},setClear:function(ve,we,Xe,Qe,de){de===!0&&(ve*=Qe,we*=Qe,Xe*=Qe),oe.set(ve,we,Xe,Qe),Ae.equals(oe)===!1&&(n.clearColor(ve,we,Xe,Qe),Ae.copy(oe))},reset:function(){k=!1,se=null,Ae.set(-1,0,0,0)}}}function i(){let k=!1,oe=!1,se=null,Ae=null,ve=null;return{setReversed:function(we){if(oe!==we){let Xe=e.get("EXT_clip_control");we?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=we;let Qe=ve;ve=null,this.setClear(Qe)}},getReversed:function(){return oe},setTest:function(we){we?xe(n.DEPTH_TEST):Ue(n.DEPTH_TEST)},setMask:function(we){se!==we&&!k&&(n.depthMask(we),se=we)},setFunc:function(we){if(oe&&(we=dx[we]),Ae!==we){switch(we){case ru:n.depthFunc(n.NEVER);break;case ou:n.depthFunc(n.ALWAYS);break;case au:n.depthFunc(n.LESS);break;case na:n.depthFunc(n.LEQUAL);break;case lu:n.depthFunc(n.EQUAL);break;case cu:n.depthFunc(n.GEQUAL);break;case uu:n.depthFunc(n.GREATER);break;case hu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=we}},setLocked:function(we){k=we},setClear:function(we){ve!==we&&(ve=we,oe&&(we=1-we),n.clearDepth(we))},reset:function(){k=!1,se=null,Ae=null,ve=null,oe=!1}}}function s(){let k=!1,oe=null,se=null,Ae=null,ve=null,we=null,Xe=null,Qe=null,de=null;return{setTest:function(ze){k||(ze?xe(n.STENCIL_TEST):Ue(n.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!k&&(n.stencilMask(ze),oe=ze)},setFunc:function(ze,et,Pe){(se!==ze||Ae!==et||ve!==Pe)&&(n.stencilFunc(ze,et,Pe),se=ze,Ae=et,ve=Pe)},setOp:function(ze,et,Pe){(we!==ze||Xe!==et||Qe!==Pe)&&(n.stencilOp(ze,et,Pe),we=ze,Xe=et,Qe=Pe)},setLocked:function(ze){k=ze},setClear:function(ze){de!==ze&&(n.clearStencil(ze),de=ze)},reset:function(){k=!1,oe=null,se=null,Ae=null,ve=null,we=null,Xe=null,Qe=null,de=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,y=[],v=null,g=!1,_=null,m=null,S=null,b=null,T=null,M=null,p=null,w=new st(0,0,0),L=0,P=!1,N=null,I=null,U=null,D=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ae=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(G)[1]),W=ae>=1):G.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),W=ae>=2);let j=null,te={},ue=n.getParameter(n.SCISSOR_BOX),K=n.getParameter(n.VIEWPORT),q=new kt().fromArray(ue),le=new kt().fromArray(K);function fe(k,oe,se,Ae){let ve=new Uint8Array(4),we=n.createTexture();n.bindTexture(k,we),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<se;Xe++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,ve):n.texImage2D(oe+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ve);return we}let ge={};ge[n.TEXTURE_2D]=fe(n.TEXTURE_2D,n.TEXTURE_2D,1),ge[n.TEXTURE_CUBE_MAP]=fe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ge[n.TEXTURE_2D_ARRAY]=fe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ge[n.TEXTURE_3D]=fe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(n.DEPTH_TEST),o.setFunc(na),dn(!1),Ut(Vd),xe(n.CULL_FACE),en(Qr);function xe(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ue(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function Je(k,oe){return f[k]!==oe?(n.bindFramebuffer(k,oe),f[k]=oe,k===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=oe),k===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ge(k,oe){let se=y,Ae=!1;if(k){se=d.get(oe),se===void 0&&(se=[],d.set(oe,se));let ve=k.textures;if(se.length!==ve.length||se[0]!==n.COLOR_ATTACHMENT0){for(let we=0,Xe=ve.length;we<Xe;we++)se[we]=n.COLOR_ATTACHMENT0+we;se.length=ve.length,Ae=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(se)}function ft(k){return v!==k?(n.useProgram(k),v=k,!0):!1}let ct={[eo]:n.FUNC_ADD,[O_]:n.FUNC_SUBTRACT,[F_]:n.FUNC_REVERSE_SUBTRACT};ct[U_]=n.MIN,ct[B_]=n.MAX;let rt={[k_]:n.ZERO,[z_]:n.ONE,[V_]:n.SRC_COLOR,[Xd]:n.SRC_ALPHA,[q_]:n.SRC_ALPHA_SATURATE,[X_]:n.DST_COLOR,[H_]:n.DST_ALPHA,[G_]:n.ONE_MINUS_SRC_COLOR,[$d]:n.ONE_MINUS_SRC_ALPHA,[$_]:n.ONE_MINUS_DST_COLOR,[W_]:n.ONE_MINUS_DST_ALPHA,[Y_]:n.CONSTANT_COLOR,[J_]:n.ONE_MINUS_CONSTANT_COLOR,[j_]:n.CONSTANT_ALPHA,[Z_]:n.ONE_MINUS_CONSTANT_ALPHA};function en(k,oe,se,Ae,ve,we,Xe,Qe,de,ze){if(k===Qr){g===!0&&(Ue(n.BLEND),g=!1);return}if(g===!1&&(xe(n.BLEND),g=!0),k!==D_){if(k!==_||ze!==P){if((m!==eo||T!==eo)&&(n.blendEquation(n.FUNC_ADD),m=eo,T=eo),ze)switch(k){case pa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFunc(n.ONE,n.ONE);break;case Hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",k);break}else switch(k){case pa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hd:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wd:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",k);break}S=null,b=null,M=null,p=null,w.set(0,0,0),L=0,_=k,P=ze}return}ve=ve||oe,we=we||se,Xe=Xe||Ae,(oe!==m||ve!==T)&&(n.blendEquationSeparate(ct[oe],ct[ve]),m=oe,T=ve),(se!==S||Ae!==b||we!==M||Xe!==p)&&(n.blendFuncSeparate(rt[se],rt[Ae],rt[we],rt[Xe]),S=se,b=Ae,M=we,p=Xe),(Qe.equals(w)===!1||de!==L)&&(n.blendColor(Qe.r,Qe.g,Qe.b,de),w.copy(Qe),L=de),_=k,P=!1}function Wt(k,oe){k.side===di?Ue(n.CULL_FACE):xe(n.CULL_FACE);let se=k.side===ui;oe&&(se=!se),dn(se),k.blending===pa&&k.transparent===!1?en(Qr):en(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),St(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?xe(n.SAMPLE_ALPHA_TO_COVERAGE):Ue(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(k){N!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),N=k)}function Ut(k){k!==I_?(xe(n.CULL_FACE),k!==I&&(k===Vd?n.cullFace(n.BACK):k===L_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ue(n.CULL_FACE),I=k}function In(k){k!==U&&(W&&n.lineWidth(k),U=k)}function St(k,oe,se){k?(xe(n.POLYGON_OFFSET_FILL),(D!==oe||V!==se)&&(D=oe,V=se,o.getReversed()&&(oe=-oe,se=-se),n.polygonOffset(oe,se))):Ue(n.POLYGON_OFFSET_FILL)}function wn(k){k?xe(n.SCISSOR_TEST):Ue(n.SCISSOR_TEST)}function rn(k){k===void 0&&(k=n.TEXTURE0+Y-1),j!==k&&(n.activeTexture(k),j=k)}function pn(k,oe,se){se===void 0&&(j===null?se=n.TEXTURE0+Y-1:se=j);let Ae=te[se];Ae===void 0&&(Ae={type:void 0,texture:void 0},te[se]=Ae),(Ae.type!==k||Ae.texture!==oe)&&(j!==se&&(n.activeTexture(se),j=se),n.bindTexture(k,oe||ge[k]),Ae.type=k,Ae.texture=oe)}function z(){let k=te[j];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function je(){try{n.compressedTexImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function at(){try{n.texSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Te(){try{n.texSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function qe(){try{n.texStorage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function O(){try{n.texStorage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function E(){try{n.texImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function J(){try{n.texImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function me(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function ce(k,oe){h[k]!==oe&&(n.pixelStorei(k,oe),h[k]=oe)}function be(k){q.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),q.copy(k))}function Se(k){le.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),le.copy(k))}function ie(k,oe){let se=c.get(oe);se===void 0&&(se=new WeakMap,c.set(oe,se));let Ae=se.get(k);Ae===void 0&&(Ae=n.getUniformBlockIndex(oe,k.name),n.uniformBlockBinding(oe,Ae,Ae),se.set(k,Ae))}function re(k,oe,se){let ve=c.get(oe).get(k);l[ve]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,ve,se),l[ve]=se)}function ye(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,te={},f={},l={},d=new WeakMap,y=[],v=null,g=!1,_=null,m=null,S=null,b=null,T=null,M=null,p=null,w=new st(0,0,0),L=0,P=!1,N=null,I=null,U=null,D=null,V=null,q.set(0,0,n.canvas.width,n.canvas.height),le.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:Ue,bindFramebuffer:Je,drawBuffers:Ge,useProgram:ft,setBlending:en,setMaterial:Wt,setFlipSided:dn,setCullFace:Ut,setLineWidth:In,setPolygonOffset:St,setScissorTest:wn,activeTexture:rn,bindTexture:pn,unbindTexture:z,compressedTexImage2D:Ie,compressedTexImage3D:je,texImage2D:E,texImage3D:J,pixelStorei:ce,getParameter:me,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:qe,texStorage3D:O,texSubImage2D:at,texSubImage3D:Te,compressedTexSubImage2D:zt,compressedTexSubImage3D:We,scissor:be,viewport:Se,reset:ye}}function FE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap,h=new Set,f,d=new WeakMap,y=new Set,v=new FinalizationRegistry(O=>y.delete(O)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(O,E){return g?new OffscreenCanvas(O,E):ul("canvas")}function m(O,E,J){let me=1,ce=qe(O);if((ce.width>J||ce.height>J)&&(me=J/Math.max(ce.width,ce.height)),me<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let be=Math.floor(me*ce.width),Se=Math.floor(me*ce.height);f===void 0&&(f=_(be,Se));let ie=E?_(be,Se):f;return ie.width=be,ie.height=Se,ie.getContext("2d").drawImage(O,0,0,be,Se),Ye("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+be+"x"+Se+")."),ie}else return"data"in O&&Ye("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),O;return O}function S(O){return O.generateMipmaps}function b(O){n.generateMipmap(O)}function T(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(O,E,J,me,ce,be=!1){if(O!==null){if(n[O]!==void 0)return n[O];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let Se;me&&(Se=e.get("EXT_texture_norm16"),Se||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=E;if(E===n.RED&&(J===n.FLOAT&&(ie=n.R32F),J===n.HALF_FLOAT&&(ie=n.R16F),J===n.UNSIGNED_BYTE&&(ie=n.R8),J===n.UNSIGNED_SHORT&&Se&&(ie=Se.R16_EXT),J===n.SHORT&&Se&&(ie=Se.R16_SNORM_EXT)),E===n.RED_INTEGER&&(J===n.UNSIGNED_BYTE&&(ie=n.R8UI),J===n.UNSIGNED_SHORT&&(ie=n.R16UI),J===n.UNSIGNED_INT&&(ie=n.R32UI),J===n.BYTE&&(ie=n.R8I),J===n.SHORT&&(ie=n.R16I),J===n.INT&&(ie=n.R32I)),E===n.RG&&(J===n.FLOAT&&(ie=n.RG32F),J===n.HALF_FLOAT&&(ie=n.RG16F),J===n.UNSIGNED_BYTE&&(ie=n.RG8),J===n.UNSIGNED_SHORT&&Se&&(ie=Se.RG16_EXT),J===n.SHORT&&Se&&(ie=Se.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(J===n.UNSIGNED_BYTE&&(ie=n.RG8UI),J===n.UNSIGNED_SHORT&&(ie=n.RG16UI),J===n.UNSIGNED_INT&&(ie=n.RG32UI),J===n.BYTE&&(ie=n.RG8I),J===n.SHORT&&(ie=n.RG16I),J===n.INT&&(ie=n.RG32I)),E===n.RGB_INTEGER&&(J===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),J===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),J===n.UNSIGNED_INT&&(ie=n.RGB32UI),J===n.BYTE&&(ie=n.RGB8I),J===n.SHORT&&(ie=n.RGB16I),J===n.INT&&(ie=n.RGB32I)),E===n.RGBA_INTEGER&&(J===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),J===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),J===n.UNSIGNED_INT&&(ie=n.RGBA32UI),J===n.BYTE&&(ie=n.RGBA8I),J===n.SHORT&&(ie=n.RGBA16I),J===n.INT&&(ie=n.RGBA32I)),E===n.RGB&&(J===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGB16_EXT),J===n.SHORT&&Se&&(ie=Se.RGB16_SNORM_EXT),J===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),J===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),E===n.RGBA){let re=be?cl:vt.getTransfer(ce);J===n.FLOAT&&(ie=n.RGBA32F),J===n.HALF_FLOAT&&(ie=n.RGBA16F),J===n.UNSIGNED_BYTE&&(ie=re===It?n.SRGB8_ALPHA8:n.RGBA8),J===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGBA16_EXT),J===n.SHORT&&Se&&(ie=Se.RGBA16_SNORM_EXT),J===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),J===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function p(O,E){let J;return O?E===null||E===is||E===no?J=n.DEPTH24_STENCIL8:E===Vi?J=n.DEPTH32F_STENCIL8:E===ga&&(J=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===is||E===no?J=n.DEPTH_COMPONENT24:E===Vi?J=n.DEPTH_COMPONENT32F:E===ga&&(J=n.DEPTH_COMPONENT16),J}function w(O,E){return S(O)===!0||O.isFramebufferTexture&&O.minFilter!==Bn&&O.minFilter!==ci?Math.log2(Math.max(E.width,E.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?E.mipmaps.length:1}function L(O){let E=new WeakRef(O);i.get(O).__ref=E,y.add(E),v.register(O,E,E)}function P(O){let E=i.get(O).__ref;E!==void 0&&(y.delete(E),v.unregister(E))}function N(O){U(O.target)}function I(O){D(O.target)}function U(O){O.removeEventListener("dispose",N),P(O),Y(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function D(O){O.removeEventListener("dispose",I),P(O),ae(O)}function V(){for(let O of y){let E=O.deref();E!==void 0&&(E.isRenderTarget===!0?D(E):U(E))}y.clear(),h.clear()}function Y(O){let E=i.get(O);if(E.__webglInit===void 0)return;let J=O.source,me=d.get(J);if(me){let ce=me[E.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&W(O),Object.keys(me).length===0&&d.delete(J)}i.remove(O)}function W(O){let E=i.get(O);n.deleteTexture(E.__webglTexture);let J=O.source,me=d.get(J);delete me[E.__cacheKey],o.memory.textures--}function ae(O){let E=i.get(O);E.__depthDisposeCallback&&E.__depthDisposeCallback();let J=O.depthTexture;if(J&&J.renderTarget===O&&U(J),O.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(E.__webglFramebuffer[ce]))for(let be=0;be<E.__webglFramebuffer[ce].length;be++)n.deleteFramebuffer(E.__webglFramebuffer[ce][be]);else n.deleteFramebuffer(E.__webglFramebuffer[ce]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[ce])}else{if(Array.isArray(E.__webglFramebuffer))for(let ce=0;ce<E.__webglFramebuffer.length;ce++)n.deleteFramebuffer(E.__webglFramebuffer[ce]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ce=0;ce<E.__webglColorRenderbuffer.length;ce++)E.__webglColorRenderbuffer[ce]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[ce]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let me=O.textures;for(let ce=0,be=me.length;ce<be;ce++){let Se=i.get(me[ce]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(me[ce])}i.remove(O)}let G=0;function j(){G=0}function te(){return G}function ue(O){G=O}function K(){let O=G;return O>=s.maxTextures&&Ye("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),G+=1,O}function q(O){let E=[];return E.push(O.wrapS),E.push(O.wrapT),E.push(O.wrapR||0),E.push(O.magFilter),E.push(O.minFilter),E.push(O.anisotropy),E.push(O.internalFormat),E.push(O.format),E.push(O.type),E.push(O.generateMipmaps),E.push(O.mipmapsAutoUpdate),E.push(O.premultiplyAlpha),E.push(O.flipY),E.push(O.unpackAlignment),E.push(O.colorSpace),E.join()}function le(O,E){let J=i.get(O);if(O.isVideoTexture&&zt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&J.__version!==O.version){let me=O.image;if(me===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(me.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(J,O,E);return}}else O.isExternalTexture&&(J.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,J.__webglTexture,n.TEXTURE0+E)}function fe(O,E){let J=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&J.__version!==O.version){Wt(J,O,E);return}else O.isExternalTexture&&(J.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,J.__webglTexture,n.TEXTURE0+E)}function ge(O,E){let J=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&J.__version!==O.version){Wt(J,O,E);return}t.bindTexture(n.TEXTURE_3D,J.__webglTexture,n.TEXTURE0+E)}function xe(O,E){let J=i.get(O);if(O.version>0&&J.__version!==O.version){dn(J,O,E);return}t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture,n.TEXTURE0+E)}let Ue={[fu]:n.REPEAT,[xs]:n.CLAMP_TO_EDGE,[du]:n.MIRRORED_REPEAT},Je={[Bn]:n.NEAREST,[ex]:n.NEAREST_MIPMAP_NEAREST,[Ll]:n.NEAREST_MIPMAP_LINEAR,[ci]:n.LINEAR,[ku]:n.LINEAR_MIPMAP_NEAREST,[js]:n.LINEAR_MIPMAP_LINEAR},Ge={[sx]:n.NEVER,[cp]:n.ALWAYS,[rx]:n.LESS,[ap]:n.LEQUAL,[ox]:n.EQUAL,[lp]:n.GEQUAL,[ax]:n.GREATER,[lx]:n.NOTEQUAL};function ft(O,E){if(E.type===Vi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===ci||E.magFilter===ku||E.magFilter===Ll||E.magFilter===js||E.minFilter===ci||E.minFilter===ku||E.minFilter===Ll||E.minFilter===js)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Ue[E.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Ue[E.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Ue[E.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,Je[E.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,Je[E.minFilter]),E.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Ge[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Bn||E.minFilter!==Ll&&E.minFilter!==js||E.type===Vi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let J=e.get("EXT_texture_filter_anisotropic");n.texParameterf(O,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ct(O,E){let J=!1;O.__webglInit===void 0&&(O.__webglInit=!0,E.addEventListener("dispose",N),L(E));let me=E.source,ce=d.get(me);ce===void 0&&(ce={},d.set(me,ce));let be=q(E);if(be!==O.__cacheKey){ce[be]===void 0&&(ce[be]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ce[be].usedTimes++;let Se=ce[O.__cacheKey];Se!==void 0&&(ce[O.__cacheKey].usedTimes--,Se.usedTimes===0&&W(E)),O.__cacheKey=be,O.__webglTexture=ce[be].texture}return J}function rt(O,E,J){return Math.floor(Math.floor(O/J)/E)}function en(O,E,J,me){let be=O.updateRanges;if(be.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,J,me,E.data);else{be.sort((k,oe)=>k.start-oe.start);let Se=0;for(let k=1;k<be.length;k++){let oe=be[Se],se=be[k],Ae=oe.start+oe.count,ve=rt(se.start,E.width,4),we=rt(oe.start,E.width,4);se.start<=Ae+1&&ve===we&&rt(se.start+se.count-1,E.width,4)===ve?oe.count=Math.max(oe.count,se.start+se.count-oe.start):(++Se,be[Se]=se)}be.length=Se+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),ye=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let k=0,oe=be.length;k<oe;k++){let se=be[k],Ae=Math.floor(se.start/4),ve=Math.ceil(se.count/4),we=Ae%E.width,Xe=Math.floor(Ae/E.width),Qe=ve,de=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,we,Xe,Qe,de,J,me,E.data)}O.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,ye)}}function Wt(O,E,J){let me=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(me=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(me=n.TEXTURE_3D);let ce=ct(O,E),be=E.source;t.bindTexture(me,O.__webglTexture,n.TEXTURE0+J);let Se=i.get(be);if(be.version!==Se.__version||ce===!0){if(t.activeTexture(n.TEXTURE0+J),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let de=vt.getPrimaries(vt.workingColorSpace),ze=E.colorSpace===Ks?null:vt.getPrimaries(E.colorSpace),et=E.colorSpace===Ks||de===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let re=m(E.image,!1,s.maxTextureSize);re=We(E,re);let ye=r.convert(E.format,E.colorSpace),k=r.convert(E.type),oe=M(E.internalFormat,ye,k,E.normalized,E.colorSpace,E.isVideoTexture);ft(me,E);let se,Ae=E.mipmaps,ve=E.isVideoTexture!==!0,we=Se.__version===void 0||ce===!0,Xe=be.dataReady,Qe=w(E,re);if(E.isDepthTexture)oe=p(E.format===Zs,E.type),we&&(ve?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ye,k,null));else if(E.isDataTexture)if(Ae.length>0){ve&&we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ae[0].width,Ae[0].height);for(let de=0,ze=Ae.length;de<ze;de++)se=Ae[de],ve?Xe&&t.texSubImage2D(n.TEXTURE_2D,de,0,0,se.width,se.height,ye,k,se.data):t.texImage2D(n.TEXTURE_2D,de,oe,se.width,se.height,0,ye,k,se.data);E.generateMipmaps=!1}else ve?(we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,re.width,re.height),Xe&&en(E,re,ye,k)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ye,k,re.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){ve&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,Ae[0].width,Ae[0].height,re.depth);for(let de=0,ze=Ae.length;de<ze;de++)if(se=Ae[de],E.format!==rs)if(ye!==null)if(ve){if(Xe)if(E.layerUpdates.size>0){let et=xp(se.width,se.height,E.format,E.type);for(let Pe of E.layerUpdates){let lt=se.data.subarray(Pe*et/se.data.BYTES_PER_ELEMENT,(Pe+1)*et/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,de,0,0,Pe,se.width,se.height,1,ye,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,de,0,0,0,se.width,se.height,re.depth,ye,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,de,oe,se.width,se.height,re.depth,0,se.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,de,0,0,0,se.width,se.height,re.depth,ye,k,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,de,oe,se.width,se.height,re.depth,0,ye,k,se.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{ve&&we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ae[0].width,Ae[0].height);for(let de=0,ze=Ae.length;de<ze;de++)se=Ae[de],E.format!==rs?ye!==null?ve?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,de,0,0,se.width,se.height,ye,se.data):t.compressedTexImage2D(n.TEXTURE_2D,de,oe,se.width,se.height,0,se.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?Xe&&t.texSubImage2D(n.TEXTURE_2D,de,0,0,se.width,se.height,ye,k,se.data):t.texImage2D(n.TEXTURE_2D,de,oe,se.width,se.height,0,ye,k,se.data)}else if(E.isDataArrayTexture)if(ve){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,re.width,re.height,re.depth),Xe)if(E.layerUpdates.size>0){let de=xp(re.width,re.height,E.format,E.type);for(let ze of E.layerUpdates){let et=re.data.subarray(ze*de/re.data.BYTES_PER_ELEMENT,(ze+1)*de/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,ye,k,et)}E.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ye,k,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,ye,k,re.data);else if(E.isData3DTexture)ve?(we&&t.texStorage3D(n.TEXTURE_3D,Qe,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ye,k,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,ye,k,re.data);else if(E.isFramebufferTexture){if(we)if(ve)t.texStorage2D(n.TEXTURE_2D,Qe,oe,re.width,re.height);else{let de=re.width,ze=re.height;for(let et=0;et<Qe;et++)t.texImage2D(n.TEXTURE_2D,et,oe,de,ze,0,ye,k,null),de>>=1,ze>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let de=n.canvas;if(de.hasAttribute("layoutsubtree")||de.setAttribute("layoutsubtree","true"),re.parentNode!==de){de.appendChild(re),h.add(E),de.onpaint=ze=>{let et=ze.changedElements;for(let Pe of h)et.includes(Pe.image)&&(Pe.needsUpdate=!0)},de.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let et=n.RGBA,Pe=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Pe,lt,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ve&&we){let de=qe(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Qe,oe,de.width,de.height)}for(let de=0,ze=Ae.length;de<ze;de++)se=Ae[de],ve?Xe&&t.texSubImage2D(n.TEXTURE_2D,de,0,0,ye,k,se):t.texImage2D(n.TEXTURE_2D,de,oe,ye,k,se);E.generateMipmaps=!1}else if(ve){if(we){let de=qe(re);t.texStorage2D(n.TEXTURE_2D,Qe,oe,de.width,de.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ye,k,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,ye,k,re);S(E)&&E.mipmapsAutoUpdate===!0&&b(me),Se.__version=be.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function dn(O,E,J){if(E.image.length!==6)return;let me=ct(O,E),ce=E.source;t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+J);let be=i.get(ce);if(ce.version!==be.__version||me===!0){t.activeTexture(n.TEXTURE0+J);let Se=vt.getPrimaries(vt.workingColorSpace),ie=E.colorSpace===Ks?null:vt.getPrimaries(E.colorSpace),re=E.colorSpace===Ks||Se===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ye=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!ye&&!k?oe[Pe]=m(E.image[Pe],!0,s.maxCubemapSize):oe[Pe]=k?E.image[Pe].image:E.image[Pe],oe[Pe]=We(E,oe[Pe]);let se=oe[0],Ae=r.convert(E.format,E.colorSpace),ve=r.convert(E.type),we=M(E.internalFormat,Ae,ve,E.normalized,E.colorSpace),Xe=E.isVideoTexture!==!0,Qe=be.__version===void 0||me===!0,de=ce.dataReady,ze=w(E,se);ft(n.TEXTURE_CUBE_MAP,E);let et;if(E.isDepthTexture){if(we=p(E.format===Zs,E.type),Qe)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,se.width,se.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,se.width,se.height,0,Ae,ve,null)}else if(ye){Xe&&Qe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,we,se.width,se.height);for(let Pe=0;Pe<6;Pe++){et=oe[Pe].mipmaps;for(let lt=0;lt<et.length;lt++){let $t=et[lt];E.format!==rs?Ae!==null?Xe?de&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,$t.width,$t.height,Ae,$t.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,we,$t.width,$t.height,0,$t.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?de&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,$t.width,$t.height,Ae,ve,$t.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,we,$t.width,$t.height,0,Ae,ve,$t.data)}}}else{if(et=E.mipmaps,Xe&&Qe){et.length>0&&ze++;let Pe=qe(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,we,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(k){Xe?de&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Ae,ve,oe[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,oe[Pe].width,oe[Pe].height,0,Ae,ve,oe[Pe].data);for(let lt=0;lt<et.length;lt++){let ni=et[lt].image[Pe].image;Xe?de&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,ni.width,ni.height,Ae,ve,ni.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,we,ni.width,ni.height,0,Ae,ve,ni.data)}}else{Xe?de&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,ve,oe[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,Ae,ve,oe[Pe]);for(let lt=0;lt<et.length;lt++){let $t=et[lt];Xe?de&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Ae,ve,$t.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,we,Ae,ve,$t.image[Pe])}}}S(E)&&E.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),be.__version=ce.version,E.onUpdate&&E.onUpdate(E)}O.__version=E.version}function Ut(O,E,J,me,ce,be){let Se=r.convert(J.format,J.colorSpace),ie=r.convert(J.type),re=M(J.internalFormat,Se,ie,J.normalized,J.colorSpace),ye=i.get(E),k=i.get(J);if(k.__renderTarget=E,!ye.__hasExternalTextures){let oe=Math.max(1,E.width>>be),se=Math.max(1,E.height>>be);ce===n.TEXTURE_3D||ce===n.TEXTURE_2D_ARRAY?t.texImage3D(ce,be,re,oe,se,E.depth,0,Se,ie,null):t.texImage2D(ce,be,re,oe,se,0,Se,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,O),Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ce,k.__webglTexture,0,at(E)):(ce===n.TEXTURE_2D||ce>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,me,ce,k.__webglTexture,be),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(O,E,J){if(n.bindRenderbuffer(n.RENDERBUFFER,O),E.depthBuffer){let me=E.depthTexture,ce=me&&me.isDepthTexture?me.type:null,be=p(E.stencilBuffer,ce),Se=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Te(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(E),be,E.width,E.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(E),be,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,be,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,O)}else{let me=E.textures;for(let ce=0;ce<me.length;ce++){let be=me[ce],Se=r.convert(be.format,be.colorSpace),ie=r.convert(be.type),re=M(be.internalFormat,Se,ie,be.normalized,be.colorSpace);Te(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(E),re,E.width,E.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(E),re,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,re,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(O,E,J){let me=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,O),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=i.get(E.depthTexture);ce.__renderTarget=E;let be=me?E.depthTexture.image[0]:E.depthTexture.image;(!ce.__webglTexture||be.width!==E.width||be.height!==E.height)&&(be.width=E.width,be.height=E.height,E.depthTexture.needsUpdate=!0),me?xe(E.depthTexture,0):le(E.depthTexture,0);let Se=ce.__webglTexture,ie=at(E),re=me?n.TEXTURE_CUBE_MAP_POSITIVE_X+J:n.TEXTURE_2D,ye=E.depthTexture.format===Zs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===Hs)Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ye,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ye,re,Se,0);else if(E.depthTexture.format===Zs)Te(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ye,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ye,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(O){let E=i.get(O),J=O.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==O.depthTexture){let me=O.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),me){let ce=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,me.removeEventListener("dispose",ce)};me.addEventListener("dispose",ce),E.__depthDisposeCallback=ce}E.__boundDepthTexture=me}if(O.depthTexture&&!E.__autoAllocateDepthBuffer)if(J)for(let me=0;me<6;me++)St(E.__webglFramebuffer[me],O,me);else O.texture.mipmaps.length>0?St(E.__webglFramebuffer[0],O,0):St(E.__webglFramebuffer,O,0);else if(J){E.__webglDepthbuffer=[];for(let me=0;me<6;me++)if(t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[me]),E.__webglDepthbuffer[me]===void 0)E.__webglDepthbuffer[me]=n.createRenderbuffer(),In(E.__webglDepthbuffer[me],O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=E.__webglDepthbuffer[me];n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,be)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),In(E.__webglDepthbuffer,O,!1);else{let ce=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,be),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,be)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function rn(O,E,J){let me=i.get(O);E!==void 0&&Ut(me.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),J!==void 0&&wn(O)}function pn(O){let E=O.texture,J=i.get(O),me=i.get(E);O.addEventListener("dispose",I),L(O);let ce=O.textures,be=O.isWebGLCubeRenderTarget===!0,Se=ce.length>1;if(Se||(me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture()),me.__version=E.version,o.memory.textures++),be){J.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0){J.__webglFramebuffer[ie]=[];for(let re=0;re<E.mipmaps.length;re++)J.__webglFramebuffer[ie][re]=n.createFramebuffer()}else J.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(E.mipmaps.length>0){J.__webglFramebuffer=[];for(let ie=0;ie<E.mipmaps.length;ie++)J.__webglFramebuffer[ie]=n.createFramebuffer()}else J.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ie=0,re=ce.length;ie<re;ie++){let ye=i.get(ce[ie]);ye.__webglTexture===void 0&&(ye.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Te(O)===!1){J.__webglMultisampledFramebuffer=n.createFramebuffer(),J.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let ie=0;ie<ce.length;ie++){let re=ce[ie];J.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,J.__webglColorRenderbuffer[ie]);let ye=r.convert(re.format,re.colorSpace),k=r.convert(re.type),oe=M(re.internalFormat,ye,k,re.normalized,re.colorSpace,O.isXRRenderTarget===!0),se=at(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,oe,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,J.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(J.__webglDepthRenderbuffer=n.createRenderbuffer(),In(J.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(be){t.bindTexture(n.TEXTURE_CUBE_MAP,me.__webglTexture),ft(n.TEXTURE_CUBE_MAP,E);for(let ie=0;ie<6;ie++)if(E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Ut(J.__webglFramebuffer[ie][re],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Ut(J.__webglFramebuffer[ie],O,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);S(E)?b(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ie=0,re=ce.length;ie<re;ie++){let ye=ce[ie],k=i.get(ye),oe=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(oe=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),ft(oe,ye),Ut(J.__webglFramebuffer,O,ye,n.COLOR_ATTACHMENT0+ie,oe,0),S(ye)&&b(oe)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ie=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,me.__webglTexture),ft(ie,E),E.mipmaps.length>0)for(let re=0;re<E.mipmaps.length;re++)Ut(J.__webglFramebuffer[re],O,E,n.COLOR_ATTACHMENT0,ie,re);else Ut(J.__webglFramebuffer,O,E,n.COLOR_ATTACHMENT0,ie,0);S(E)?b(ie):E.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&wn(O)}function z(O){let E=O.textures;for(let J=0,me=E.length;J<me;J++){let ce=E[J];if(S(ce)&&ce.mipmapsAutoUpdate===!0){let be=T(O),Se=i.get(ce).__webglTexture;t.bindTexture(be,Se),b(be),t.unbindTexture()}}}let Ie=[];function je(O){if(O.samples>0){if(Te(O)===!1){let E=O.textures,J=O.width,me=O.height,ce=n.COLOR_BUFFER_BIT,be=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(O),ie=E.length>1;if(ie)for(let ye=0;ye<E.length;ye++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ye,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ye,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let ye=0;ye<E.length;ye++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ce|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ce|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[ye]);let k=i.get(E[ye]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,J,me,0,0,J,me,ce,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+ye),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Ie.push(be),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let ye=0;ye<E.length;ye++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ye,n.RENDERBUFFER,Se.__webglColorRenderbuffer[ye]);let k=i.get(E[ye]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ye,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let E=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function at(O){return Math.min(s.maxSamples,O.samples)}function Te(O){let E=i.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function zt(O){let E=o.render.frame;u.get(O)!==E&&(u.set(O,E),O.update())}function We(O,E){let J=O.colorSpace,me=O.format,ce=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||J!==ll&&J!==Ks&&(vt.getTransfer(J)===It?(me!==rs||ce!==pi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",J)),E}function qe(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=K,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=ue,this.setTexture2D=le,this.setTexture2DArray=fe,this.setTexture3D=ge,this.setTextureCube=xe,this.rebindTextures=rn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Te,this.dispose=V}function UE(n,e){function t(i,s=Ks){let r,o=vt.getTransfer(s);if(i===pi)return n.UNSIGNED_BYTE;if(i===Vu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Gu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ip)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===tp)return n.BYTE;if(i===np)return n.SHORT;if(i===ga)return n.UNSIGNED_SHORT;if(i===zu)return n.INT;if(i===is)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===ss)return n.HALF_FLOAT;if(i===rp)return n.ALPHA;if(i===op)return n.RGB;if(i===rs)return n.RGBA;if(i===Hs)return n.DEPTH_COMPONENT;if(i===Zs)return n.DEPTH_STENCIL;if(i===Hu)return n.RED;if(i===Wu)return n.RED_INTEGER;if(i===Ar)return n.RG;if(i===Xu)return n.RG_INTEGER;if(i===$u)return n.RGBA_INTEGER;if(i===Nl||i===Dl||i===Ol||i===Fl)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Nl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Nl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ol)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Fl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===qu||i===Yu||i===Ju||i===ju)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===qu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Yu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ju)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ju)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Zu||i===Ku||i===Qu||i===eh||i===th||i===Ul||i===nh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Zu||i===Ku)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Qu)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===eh)return r.COMPRESSED_R11_EAC;if(i===th)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ul)return r.COMPRESSED_RG11_EAC;if(i===nh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ih||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===fh||i===dh||i===ph||i===mh||i===gh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ih)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===sh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===rh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===oh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ch)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===uh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===hh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===mh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===gh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===_h||i===xh||i===yh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===_h)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===xh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===yh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===vh||i===bh||i===Bl||i===Sh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===vh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Bl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Sh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===no?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var BE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,kE=`
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

}`,Ep=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new bl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new zi({vertexShader:BE,fragmentShader:kE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Mn(new Sl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cp=class extends ts{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,y=null,v=typeof XRWebGLBinding<"u",g=new Ep,_={},m=t.getContextAttributes(),S=null,b=null,T=[],M=[],p=new Ke,w=null,L=null,P=new Ci;P.viewport=new kt;let N=new Ci;N.viewport=new kt;let I=[P,N],U=new Ou,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(q){let le=T[q];return le===void 0&&(le=new la,T[q]=le),le.getTargetRaySpace()},this.getControllerGrip=function(q){let le=T[q];return le===void 0&&(le=new la,T[q]=le),le.getGripSpace()},this.getHand=function(q){let le=T[q];return le===void 0&&(le=new la,T[q]=le),le.getHandSpace()};function Y(q){let le=M.indexOf(q.inputSource);if(le===-1)return;let fe=T[le];fe!==void 0&&(fe.update(q.inputSource,q.frame,c||o),fe.dispatchEvent({type:q.type,data:q.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ae);for(let q=0;q<T.length;q++){let le=M[q];le!==null&&(M[q]=null,T[q].disconnect(le))}D=null,V=null,g.reset();for(let q in _)delete _[q];if(e.setRenderTarget(S),d=null,f=null,h=null,s=null,b=null,K.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(p.width,p.height,!1),L!==null){let q=L.camera;q.fov=L.fov,q.zoom=L.zoom,q.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(q){r=q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(q){a=q,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(q){c=q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return y},this.getSession=function(){return s},this.setSession=async function(q){if(s=q,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ae),m.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(p),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let fe=null,ge=null,xe=null;m.depth&&(xe=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,fe=m.stencil?Zs:Hs,ge=m.stencil?no:is);let Ue={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ue),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),b=new Ri(f.textureWidth,f.textureHeight,{format:rs,type:pi,depthTexture:new Js(f.textureWidth,f.textureHeight,ge,void 0,void 0,void 0,void 0,void 0,void 0,fe),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let fe={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,fe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new Ri(d.framebufferWidth,d.framebufferHeight,{format:rs,type:pi,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),K.setContext(s),K.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ae(q){for(let le=0;le<q.removed.length;le++){let fe=q.removed[le],ge=M.indexOf(fe);ge>=0&&(M[ge]=null,T[ge].disconnect(fe))}for(let le=0;le<q.added.length;le++){let fe=q.added[le],ge=M.indexOf(fe);if(ge===-1){for(let Ue=0;Ue<T.length;Ue++)if(Ue>=M.length){M.push(fe),ge=Ue;break}else if(M[Ue]===null){M[Ue]=fe,ge=Ue;break}if(ge===-1)break}let xe=T[ge];xe&&xe.connect(fe)}}function G(q,le){le===null?q.matrixWorld.copy(q.matrix):q.matrixWorld.multiplyMatrices(le.matrixWorld,q.matrix),q.matrixWorldInverse.copy(q.matrixWorld).invert()}this.updateCamera=function(q){if(s===null)return;let le=q.near,fe=q.far;g.texture!==null&&(g.depthNear>0&&(le=g.depthNear),g.depthFar>0&&(fe=g.depthFar)),U.near=N.near=P.near=le,U.far=N.far=P.far=fe,(D!==U.near||V!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),D=U.near,V=U.far),U.layers.mask=q.layers.mask|6,P.layers.mask=U.layers.mask&-5,N.layers.mask=U.layers.mask&-3;let ge=q.parent,xe=U.cameras;G(U,ge);for(let Ue=0;Ue<xe.length;Ue++)G(xe[Ue],ge);U.projectionMatrix.copy(P.projectionMatrix),U.projectionMatrixInverse.copy(P.projectionMatrixInverse),L===null&&q.isPerspectiveCamera&&(L={camera:q,fov:q.fov,zoom:q.zoom}),j(q,U,ge)};function j(q,le,fe){fe===null?q.matrix.copy(le.matrixWorld):(q.matrix.copy(fe.matrixWorld),q.matrix.invert(),q.matrix.multiply(le.matrixWorld)),q.matrix.decompose(q.position,q.quaternion,q.scale),q.updateMatrixWorld(!0),q.projectionMatrix.copy(le.projectionMatrix),q.projectionMatrixInverse.copy(le.projectionMatrixInverse),q.isPerspectiveCamera&&(q.fov=ra*2*Math.atan(1/q.projectionMatrix.elements[5]),q.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(q){l=q,f!==null&&(f.fixedFoveation=q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(U)},this.getCameraTexture=function(q){return _[q]};let te=null;function ue(q,le){if(u=le.getViewerPose(c||o),y=le,u!==null){let fe=u.views;d!==null&&(e.setRenderTargetFramebuffer(b,d.framebuffer),e.setRenderTarget(b));let ge=!1;fe.length!==U.cameras.length&&(U.cameras.length=0,ge=!0);for(let Ge=0;Ge<fe.length;Ge++){let ft=fe[Ge],ct=null;if(d!==null)ct=d.getViewport(ft);else{let en=h.getViewSubImage(f,ft);ct=en.viewport,Ge===0&&(e.setRenderTargetTextures(b,en.colorTexture,en.depthStencilTexture),e.setRenderTarget(b))}let rt=I[Ge];rt===void 0&&(rt=new Ci,rt.layers.enable(Ge),rt.viewport=new kt,I[Ge]=rt),rt.matrix.fromArray(ft.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(ft.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ct.x,ct.y,ct.width,ct.height),Ge===0&&(U.matrix.copy(rt.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),ge===!0&&U.cameras.push(rt)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let Ge=h.getDepthInformation(fe[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(xe&&xe.includes("camera-access")&&v){e.state.unbindTexture(),h=i.getBinding();for(let Ge=0;Ge<fe.length;Ge++){let ft=fe[Ge].camera;if(ft){let ct=_[ft];ct||(ct=new bl,_[ft]=ct);let rt=h.getCameraImage(ft);ct.sourceTexture=rt}}}}for(let fe=0;fe<T.length;fe++){let ge=M[fe],xe=T[fe];ge!==null&&xe!==void 0&&xe.update(ge,le,c||o)}te&&te(q,le),le.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:le}),y=null}let K=new Vx;K.setAnimationLoop(ue),this.setAnimationLoop=function(q){te=q},this.dispose=function(){}}},zE=new gt,Zx=new nt;Zx.set(-1,0,0,0,1,0,0,0,1);function VE(n,e){function t(g,_){g.matrixAutoUpdate===!0&&g.updateMatrix(),_.value.copy(g.matrix)}function i(g,_){_.color.getRGB(g.fogColor.value,mp(n)),_.isFog?(g.fogNear.value=_.near,g.fogFar.value=_.far):_.isFogExp2&&(g.fogDensity.value=_.density)}function s(g,_,m,S,b){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(g,_):_.isMeshLambertMaterial?(r(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(g,_),h(g,_)):_.isMeshPhongMaterial?(r(g,_),u(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(g,_),f(g,_),_.isMeshPhysicalMaterial&&d(g,_,b)):_.isMeshMatcapMaterial?(r(g,_),y(g,_)):_.isMeshDepthMaterial?r(g,_):_.isMeshDistanceMaterial?(r(g,_),v(g,_)):_.isMeshNormalMaterial?r(g,_):_.isLineBasicMaterial?(o(g,_),_.isLineDashedMaterial&&a(g,_)):_.isPointsMaterial?l(g,_,m,S):_.isSpriteMaterial?c(g,_):_.isShadowMaterial?(g.color.value.copy(_.color),g.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(g,_){g.opacity.value=_.opacity,_.color&&g.diffuse.value.copy(_.color),_.emissive&&g.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.bumpMap&&(g.bumpMap.value=_.bumpMap,t(_.bumpMap,g.bumpMapTransform),g.bumpScale.value=_.bumpScale,_.side===ui&&(g.bumpScale.value*=-1)),_.normalMap&&(g.normalMap.value=_.normalMap,t(_.normalMap,g.normalMapTransform),g.normalScale.value.copy(_.normalScale),_.side===ui&&g.normalScale.value.negate()),_.displacementMap&&(g.displacementMap.value=_.displacementMap,t(_.displacementMap,g.displacementMapTransform),g.displacementScale.value=_.displacementScale,g.displacementBias.value=_.displacementBias),_.emissiveMap&&(g.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,g.emissiveMapTransform)),_.specularMap&&(g.specularMap.value=_.specularMap,t(_.specularMap,g.specularMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest);let m=e.get(_),S=m.envMap,b=m.envMapRotation;S&&(g.envMap.value=S,g.envMapRotation.value.setFromMatrix4(zE.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Zx),g.reflectivity.value=_.reflectivity,g.ior.value=_.ior,g.refractionRatio.value=_.refractionRatio),_.lightMap&&(g.lightMap.value=_.lightMap,g.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,g.lightMapTransform)),_.aoMap&&(g.aoMap.value=_.aoMap,g.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,g.aoMapTransform))}function o(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform))}function a(g,_){g.dashSize.value=_.dashSize,g.totalSize.value=_.dashSize+_.gapSize,g.scale.value=_.scale}function l(g,_,m,S){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.size.value=_.size*m,g.scale.value=S*.5,_.map&&(g.map.value=_.map,t(_.map,g.uvTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function c(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.rotation.value=_.rotation,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function u(g,_){g.specular.value.copy(_.specular),g.shininess.value=Math.max(_.shininess,1e-4)}function h(g,_){_.gradientMap&&(g.gradientMap.value=_.gradientMap)}function f(g,_){g.metalness.value=_.metalness,_.metalnessMap&&(g.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,g.metalnessMapTransform)),g.roughness.value=_.roughness,_.roughnessMap&&(g.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,g.roughnessMapTransform)),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)}function d(g,_,m){g.ior.value=_.ior,_.diffuseRoughness>0&&(g.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),_.sheen>0&&(g.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),g.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(g.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,g.sheenColorMapTransform)),_.sheenRoughnessMap&&(g.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,g.sheenRoughnessMapTransform))),_.clearcoat>0&&(g.clearcoat.value=_.clearcoat,g.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(g.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,g.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(g.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===ui&&g.clearcoatNormalScale.value.negate())),_.dispersion>0&&(g.dispersion.value=_.dispersion),_.retroreflectivity>0&&(g.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(g.iridescence.value=_.iridescence,g.iridescenceIOR.value=_.iridescenceIOR,g.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(g.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,g.iridescenceMapTransform)),_.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),_.transmission>0&&(g.transmission.value=_.transmission,g.transmissionSamplerMap.value=m.texture,g.transmissionSamplerSize.value.set(m.width,m.height),_.transmissionMap&&(g.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,g.transmissionMapTransform)),g.thickness.value=_.thickness,_.thicknessMap&&(g.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=_.attenuationDistance,g.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(g.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(g.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=_.specularIntensity,g.specularColor.value.copy(_.specularColor),_.specularColorMap&&(g.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,g.specularColorMapTransform)),_.specularIntensityMap&&(g.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,g.specularIntensityMapTransform))}function y(g,_){_.matcap&&(g.matcap.value=_.matcap)}function v(g,_){let m=e.get(_).light;g.referencePosition.value.setFromMatrixPosition(m.matrixWorld),g.nearDistance.value=m.shadow.camera.near,g.farDistance.value=m.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function GE(n,e,t,i){let s={},r={};function o(m,S){let b=S.program;i.uniformBlockBinding(m,b,s[m.id])}function a(m,S){let b=s[m.id];b===void 0&&(y(m),b=l(m),s[m.id]=b,m.addEventListener("dispose",g));let T=S.program;i.updateUBOMapping(m,T);let M=e.render.frame;r[m.id]!==M&&(c(m),r[m.id]=M)}function l(m){let S=n.createBuffer(),b=m.__size,T=m.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,b,T),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(m){let S=s[m.id],b=m.uniforms,T=m.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let M=0,p=b.length;M<p;M++){let w=b[M];if(Array.isArray(w))for(let L=0,P=w.length;L<P;L++)u(w[L],M,L,T);else u(w,M,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(m,S,b,T){if(f(m,S,b,T)===!0){let M=m.__offset,p=m.value;if(Array.isArray(p)){let w=0;for(let L=0;L<p.length;L++){let P=p[L],N=v(P,!0);h(P,m.__data,w),w+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(p,m.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,m.__data)}}function h(m,S,b){typeof m=="number"||typeof m=="boolean"?S[b]=m:m.isMatrix3?(S[b]=m.elements[0],S[b+1]=m.elements[1],S[b+2]=m.elements[2],S[b+3]=0,S[b+4]=m.elements[3],S[b+5]=m.elements[4],S[b+6]=m.elements[5],S[b+7]=0,S[b+8]=m.elements[6],S[b+9]=m.elements[7],S[b+10]=m.elements[8],S[b+11]=0):ArrayBuffer.isView(m)?S.set(m.subarray(0,S.length-b),b):m.toArray(S,b)}function f(m,S,b,T){let M=m.value,p=S+"_"+b;if(Array.isArray(M)){T[p]===void 0&&(T[p]=[]);let w=T[p],L=!1;for(let P=0;P<M.length;P++)d(M[P],w,P)===!0&&(L=!0);return L}return d(M,T,p)}function d(m,S,b){if(S[b]===void 0)return typeof m=="number"||typeof m=="boolean"?S[b]=m:ArrayBuffer.isView(m)?S[b]=m.slice():S[b]=m.clone(),!0;{let T=S[b];if(typeof m=="number"||typeof m=="boolean"){if(T!==m)return S[b]=m,!0}else{if(ArrayBuffer.isView(m))return!0;if(T.equals(m)===!1)return T.copy(m),!0}}return!1}function y(m){let S=m.uniforms,b=0,T=16;for(let p=0,w=S.length;p<w;p++){let L=Array.isArray(S[p])?S[p]:[S[p]];for(let P=0,N=L.length;P<N;P++){let I=L[P],U=Array.isArray(I.value)?I.value:[I.value],D=Array.isArray(S[p])||Array.isArray(I.value),V=b;for(let W=0,ae=U.length;W<ae;W++){let G=U[W],j=v(G,D),te=b%T,ue=te%j.boundary,K=te+ue;b+=ue,K!==0&&T-K<j.storage&&(b+=T-K),W===0&&(V=b),b+=j.storage}let Y=I.type==="int"?Int32Array:I.type==="uint"?Uint32Array:Float32Array;I.__data=new Y((b-V)/Float32Array.BYTES_PER_ELEMENT),I.__offset=V}}let M=b%T;return M>0&&(b+=T-M),m.__size=b,m.__cache={},this}function v(m,S){let b={boundary:0,storage:0};return typeof m=="number"||typeof m=="boolean"?(b.boundary=4,b.storage=4):m.isVector2?(b.boundary=8,b.storage=8):m.isVector3||m.isColor?(b.boundary=16,b.storage=12):m.isVector4?(b.boundary=16,b.storage=16):m.isMatrix3?(b.boundary=16,b.storage=48):m.isMatrix4?(b.boundary=16,b.storage=64):m.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(m)?(b.boundary=16,b.storage=m.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",m),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(m){let S=m.target;S.removeEventListener("dispose",g),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function _(){for(let m in s)n.deleteBuffer(s[m]);s={},r={}}return{bind:o,update:a,dispose:_}}var HE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ss=null;function WE(){return Ss===null&&(Ss=new Ys(HE,16,16,Ar,ss),Ss.name="DFG_LUT",Ss.minFilter=ci,Ss.magFilter=ci,Ss.wrapS=xs,Ss.wrapT=xs,Ss.generateMipmaps=!1,Ss.needsUpdate=!0),Ss}var ws=class{constructor(e={}){let{canvas:t=ux(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=pi}=e;this.isWebGLRenderer=!0;let y;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");y=i.getContextAttributes().alpha}else y=o;let v=d,g=new Set([$u,Xu,Wu]),_=new Set([pi,is,ga,no,Vu,Gu]),m=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},T=null,M=null,p=[],w=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=bs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,N=!1,I=null,U=null,D=null,V=null;this._outputColorSpace=Kn;let Y=0,W=0,ae=null,G=-1,j=null,te=new kt,ue=new kt,K=null,q=new st(0),le=0,fe=t.width,ge=t.height,xe=1,Ue=null,Je=null,Ge=new kt(0,0,fe,ge),ft=new kt(0,0,fe,ge),ct=!1,rt=new yr,en=new xu,Wt=!1,dn=!1,Ut=new gt,In=new X,St=new kt,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function pn(){return ae===null?xe:1}let z=i;function Ie(R,H){return t.getContext(R,H)}let je,at,Te,zt,We,qe,O,E,J,me,ce,be,Se,ie,re,ye,k,oe,se,Ae,ve,we,Xe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),z===null){let H="webgl2";if(z=Ie(H,R),z===null)throw Ie(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(R){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),tt("WebGLRenderer: "+R.message),R}function Qe(){je=new tA(z),je.init(),ve=new UE(z,je),at=new WT(z,je,e,ve),Te=new OE(z,je),at.reversedDepthBuffer&&f&&Te.buffers.depth.setReversed(!0),U=z.createFramebuffer(),D=z.createFramebuffer(),V=z.createFramebuffer(),zt=new sA(z),We=new bE,qe=new FE(z,je,Te,We,at,ve,zt),O=new eA(P),E=new ow(z),we=new GT(z,E),J=new nA(z,E,zt,we),me=new oA(z,J,E,we,zt),oe=new rA(z,at,qe),re=new XT(We),ce=new vE(P,O,je,at,we,re),be=new VE(P,We),Se=new ME,ie=new RE(je),k=new VT(P,O,Te,me,y,l),ye=new DE(P,me,at),Xe=new GE(z,zt,at,Te),se=new HT(z,je,zt),Ae=new iA(z,je,zt),zt.programs=ce.programs,P.capabilities=at,P.extensions=je,P.properties=We,P.renderLists=Se,P.shadowMap=ye,P.state=Te,P.info=zt}v!==pi&&(L=new lA(v,t.width,t.height,a,s,r));let de=new Cp(P,z);this.xr=de,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let R=je.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=je.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(R){R!==void 0&&(xe=R,this.setSize(fe,ge,!1))},this.getSize=function(R){return R.set(fe,ge)},this.setSize=function(R,H,ne=!0){if(de.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}fe=R,ge=H,t.width=Math.floor(R*xe),t.height=Math.floor(H*xe),ne===!0&&(t.style.width=R+"px",t.style.height=H+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(fe*xe,ge*xe).floor()},this.setDrawingBufferSize=function(R,H,ne){fe=R,ge=H,xe=ne,t.width=Math.floor(R*ne),t.height=Math.floor(H*ne),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(v===pi){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(te)},this.getViewport=function(R){return R.copy(Ge)},this.setViewport=function(R,H,ne,Z){R.isVector4?Ge.set(R.x,R.y,R.z,R.w):Ge.set(R,H,ne,Z),Te.viewport(te.copy(Ge).multiplyScalar(pn()).round())},this.getScissor=function(R){return R.copy(ft)},this.setScissor=function(R,H,ne,Z){R.isVector4?ft.set(R.x,R.y,R.z,R.w):ft.set(R,H,ne,Z),Te.scissor(ue.copy(ft).multiplyScalar(pn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(R){Te.setScissorTest(ct=R)},this.setOpaqueSort=function(R){Ue=R},this.setTransparentSort=function(R){Je=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,ne=!0){let Z=0;if(R){let Q=!1;if(ae!==null){let Ee=ae.texture.format;Q=g.has(Ee)}if(Q){let Ee=ae.texture.type,Le=_.has(Ee),Ce=k.getClearColor(),Ne=k.getClearAlpha(),He=Ce.r,it=Ce.g,dt=Ce.b;Le?(m[0]=He,m[1]=it,m[2]=dt,m[3]=Ne,z.clearBufferuiv(z.COLOR,0,m)):(S[0]=He,S[1]=it,S[2]=dt,S[3]=Ne,z.clearBufferiv(z.COLOR,0,S))}else Z|=z.COLOR_BUFFER_BIT}H&&(Z|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(Z|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&z.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),I=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),k.dispose(),Se.dispose(),ie.dispose(),qe.dispose(),We.dispose(),O.dispose(),me.dispose(),J.dispose(),we.dispose(),Xe.dispose(),ce.dispose(),de.dispose(),de.removeEventListener("sessionstart",jl),de.removeEventListener("sessionend",ls),Cs.stop()};function ze(R){R.preventDefault(),hp("WebGLRenderer: Context Lost."),N=!0}function et(){hp("WebGLRenderer: Context Restored."),N=!1;let R=zt.autoReset,H=ye.enabled,ne=ye.autoUpdate,Z=ye.needsUpdate,Q=ye.type;Qe(),zt.autoReset=R,ye.enabled=H,ye.autoUpdate=ne,ye.needsUpdate=Z,ye.type=Q}function Pe(R){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function lt(R){let H=R.target;H.removeEventListener("dispose",lt),$t(H)}function $t(R){ni(R),We.remove(R)}function ni(R){let H=We.get(R).programs;H!==void 0&&(H.forEach(function(ne){ce.releaseProgram(ne)}),R.isShaderMaterial&&ce.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,ne,Z,Q,Ee){H===null&&(H=wn);let Le=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Ce=Ia(R,H,ne,Z,Q);Te.setMaterial(Z,Le);let Ne=ne.index,He=1;if(Z.wireframe===!0){if(Ne=J.getWireframeAttribute(ne),Ne===void 0)return;He=2}let it=ne.drawRange,dt=ne.attributes.position,Ve=it.start*He,pt=(it.start+it.count)*He;Ee!==null&&(Ve=Math.max(Ve,Ee.start*He),pt=Math.min(pt,(Ee.start+Ee.count)*He)),Ne!==null?(Ve=Math.max(Ve,0),pt=Math.min(pt,Ne.count)):dt!=null&&(Ve=Math.max(Ve,0),pt=Math.min(pt,dt.count));let nn=pt-Ve;if(nn<0||nn===1/0)return;we.setup(Q,Z,Ce,ne,Ne);let Lt,Nt=se;if(Ne!==null&&(Lt=E.get(Ne),Nt=Ae,Nt.setIndex(Lt)),Q.isMesh)Z.wireframe===!0?(Te.setLineWidth(Z.wireframeLinewidth*pn()),Nt.setMode(z.LINES)):Nt.setMode(z.TRIANGLES);else if(Q.isLine){let Tn=Z.linewidth;Tn===void 0&&(Tn=1),Te.setLineWidth(Tn*pn()),Q.isLineSegments?Nt.setMode(z.LINES):Q.isLineLoop?Nt.setMode(z.LINE_LOOP):Nt.setMode(z.LINE_STRIP)}else Q.isPoints?Nt.setMode(z.POINTS):Q.isSprite&&Nt.setMode(z.TRIANGLES);if(Q.isBatchedMesh)if(je.get("WEBGL_multi_draw"))Nt.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let Tn=Q._multiDrawStarts,Be=Q._multiDrawCounts,mn=Q._multiDrawCount,xt=Ne?E.get(Ne).bytesPerElement:1,Ps=We.get(Z).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)Ps.setValue(z,"_gl_DrawID",gn),Nt.render(Tn[gn]/xt,Be[gn])}else if(Q.isInstancedMesh)Nt.renderInstances(Ve,nn,Q.count);else if(ne.isInstancedBufferGeometry){let Tn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,Be=Math.min(ne.instanceCount,Tn);Nt.renderInstances(Ve,nn,Be)}else Nt.render(Ve,nn)};function Ca(R,H,ne,Z){I!==null&&R.isNodeMaterial&&I.setObject(Z,R),Wt===!0&&re.setState(R,ne,!1),R.transparent===!0&&R.side===di&&R.forceSinglePass===!1?(R.side=ui,R.needsUpdate=!0,cs(R,H,Z),R.side=Tr,R.needsUpdate=!0,cs(R,H,Z),R.side=di):cs(R,H,Z)}this.compile=function(R,H,ne=null){ne===null&&(ne=R),I!==null&&I.renderStart(R,H,ne),M=ie.get(ne),M.init(H),w.push(M),ne.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(M.pushLight(Q),Q.castShadow&&M.pushShadow(Q))}),R!==ne&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(M.pushLight(Q),Q.castShadow&&M.pushShadow(Q))}),M.setupLights(),I!==null&&I.updateLights(M.state.lightsArray),dn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,dn),Wt===!0&&re.setGlobalState(this.clippingPlanes,H),I!==null&&ye.render(M.state.shadowsArray,ne,H);let Z=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Ee=Q.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ce=Ee[Le];Ca(Ce,ne,H,Q),Z.add(Ce)}else Ca(Ee,ne,H,Q),Z.add(Ee)}),M=w.pop(),I!==null&&I.renderEnd(),Z},this.compileAsync=function(R,H,ne=null){let Z=this.compile(R,H,ne);return new Promise(Q=>{function Ee(){if(Z.forEach(function(Le){let Ne=We.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&Z.delete(Le)}),Z.size===0){Q(R);return}setTimeout(Ee,10)}je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let po=null;function of(R){po&&po(R)}function jl(){Cs.stop()}function ls(){Cs.start()}let Cs=new Vx;Cs.setAnimationLoop(of),typeof self<"u"&&Cs.setContext(self),this.setAnimationLoop=function(R){po=R,de.setAnimationLoop(R),R===null?Cs.stop():Cs.start()},de.addEventListener("sessionstart",jl),de.addEventListener("sessionend",ls),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;I!==null&&I.renderStart(R,H);let ne=de.enabled===!0&&de.isPresenting===!0,Z=L!==null&&(ae===null||ne)&&L.begin(P,ae);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),de.enabled===!0&&de.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(de.cameraAutoUpdate===!0&&de.updateCamera(H),H=de.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,H,ae),M=ie.get(R,w.length),M.init(H),M.state.textureUnits=qe.getTextureUnits(),w.push(M),Ut.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?en.setFromArrayCamera(H):rt.setFromProjectionMatrix(Ut,ki,H.reversedDepth),dn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,dn),T=Se.get(R,p.length),T.init(),p.push(T),this.info.render.frame++,de.enabled===!0&&de.isPresenting===!0){let Le=P.xr.getDepthSensingMesh();Le!==null&&Rs(Le,H,-1/0,P.sortObjects)}Rs(R,H,0,P.sortObjects),T.finish(),I!==null&&I.updateLights(M.state.lightsArray),P.sortObjects===!0&&T.sort(Ue,Je),rn=de.enabled===!1||de.isPresenting===!1||de.hasDepthSensing()===!1,rn&&k.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&re.beginShadows();let Q=M.state.shadowsArray;if(ye.render(Q,R,H),Wt===!0&&re.endShadows(),(Z&&L.hasRenderPass())===!1){let Le=T.opaque,Ce=T.transmissive;if(M.setupLights(),H.isArrayCamera){let Ne=H.cameras;if(Ce.length>0)for(let He=0,it=Ne.length;He<it;He++){let dt=Ne[He];Hi(Le,Ce,R,dt)}rn&&k.render(R);for(let He=0,it=Ne.length;He<it;He++){let dt=Ne[He];Ra(T,R,dt,dt.viewport)}}else Ce.length>0&&Hi(Le,Ce,R,H),rn&&k.render(R),Ra(T,R,H)}ae!==null&&W===0&&(qe.updateMultisampleRenderTarget(ae),qe.updateRenderTargetMipmap(ae)),Z&&L.end(P),R.isScene===!0&&R.onAfterRender(P,R,H),we.resetDefaultState(),G=-1,j=null,w.pop(),w.length>0?(M=w[w.length-1],qe.setTextureUnits(M.state.textureUnits),Wt===!0&&re.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,p.pop(),p.length>0?T=p[p.length-1]:T=null,I!==null&&I.renderEnd()};function Rs(R,H,ne,Z){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)ne=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)M.pushLight(R),R.castShadow&&M.pushShadow(R);else if(R.isSprite){let Le=H.isArrayCamera?en:rt;if(!R.frustumCulled||R.intersectsFrustum(Le)){Z&&St.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ut);let Ce=me.update(R),Ne=R.material;Ne.visible&&T.push(R,Ce,Ne,ne,St.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=H.isArrayCamera?en:rt;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Ce=me.update(R),Ne=R.material;if(Z&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),St.copy(R.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),St.copy(Ce.boundingSphere.center)),St.applyMatrix4(R.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ne)){let He=Ce.groups;for(let it=0,dt=He.length;it<dt;it++){let Ve=He[it],pt=Ne[Ve.materialIndex];pt&&pt.visible&&T.push(R,Ce,pt,ne,St.z,Ve,H)}}else Ne.visible&&T.push(R,Ce,Ne,ne,St.z,null,H)}}}let Ee=R.children;for(let Le=0,Ce=Ee.length;Le<Ce;Le++)Rs(Ee[Le],H,ne,Z)}function Ra(R,H,ne,Z){let{opaque:Q,transmissive:Ee,transparent:Le}=R;M.setupLightsView(ne),Wt===!0&&re.setGlobalState(P.clippingPlanes,ne),Z&&Te.viewport(te.copy(Z)),Q.length>0&&on(Q,H,ne),Ee.length>0&&on(Ee,H,ne),Le.length>0&&on(Le,H,ne),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function Hi(R,H,ne,Z){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Z.id]===void 0){let Ve=je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Z.id]=new Ri(1,1,{generateMipmaps:!0,type:Ve?ss:pi,minFilter:js,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ee=M.state.transmissionRenderTarget[Z.id],Le=Z.viewport||te;Ee.setSize(Le.z*P.transmissionResolutionScale,Le.w*P.transmissionResolutionScale);let Ce=P.getRenderTarget(),Ne=P.getActiveCubeFace(),He=P.getActiveMipmapLevel();P.setRenderTarget(Ee),P.getClearColor(q),le=P.getClearAlpha(),le<1&&P.setClearColor(16777215,.5),P.clear(),rn&&k.render(ne);let it=P.toneMapping;P.toneMapping=bs;let dt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),M.setupLightsView(Z),Wt===!0&&re.setGlobalState(P.clippingPlanes,Z),on(R,ne,Z),qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee),je.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let pt=0,nn=H.length;pt<nn;pt++){let Lt=H[pt],{object:Nt,geometry:Tn,material:Be,group:mn}=Lt;if(Be.side===di&&Nt.layers.test(Z.layers)){let xt=Be.side;Be.side=ui,Be.needsUpdate=!0,un(Nt,ne,Z,Tn,Be,mn),Be.side=xt,Be.needsUpdate=!0,Ve=!0}}Ve===!0&&(qe.updateMultisampleRenderTarget(Ee),qe.updateRenderTargetMipmap(Ee))}P.setRenderTarget(Ce,Ne,He),P.setClearColor(q,le),dt!==void 0&&(Z.viewport=dt),P.toneMapping=it}function on(R,H,ne){let Z=H.isScene===!0?H.overrideMaterial:null;for(let Q=0,Ee=R.length;Q<Ee;Q++){let Le=R[Q],{object:Ce,geometry:Ne,group:He}=Le,it=Le.material;it.allowOverride===!0&&Z!==null&&(it=Z),Ce.layers.test(ne.layers)&&un(Ce,H,ne,Ne,it,He)}}function un(R,H,ne,Z,Q,Ee){I!==null&&Q.isNodeMaterial&&I.setObject(R,Q),R.onBeforeRender(P,H,ne,Z,Q,Ee),R.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(P,H,ne,Z,R,Ee),Q.transparent===!0&&Q.side===di&&Q.forceSinglePass===!1?(Q.side=ui,Q.needsUpdate=!0,P.renderBufferDirect(ne,H,Z,Q,R,Ee),Q.side=Tr,Q.needsUpdate=!0,P.renderBufferDirect(ne,H,Z,Q,R,Ee),Q.side=di):P.renderBufferDirect(ne,H,Z,Q,R,Ee),R.onAfterRender(P,H,ne,Z,Q,Ee)}function hn(R){let H=0;for(let ne of R)ne.texture!==null&&H++;return H}function cs(R,H,ne){H.isScene!==!0&&(H=wn);let Z=We.get(R),Q=M.state.lights,Ee=M.state.shadowsArray,Le=Q.state.version,Ce=ce.getParameters(R,Q.state,Ee,H,ne,M.state.lightProbeGridArray),Ne=ce.getProgramCacheKey(Ce),He=Z.programs;Z.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Z.fog=H.fog;let it=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Z.envMap=O.get(R.envMap||Z.environment,it),Z.envMapRotation=Z.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,He===void 0&&(R.addEventListener("dispose",lt),He=new Map,Z.programs=He,Z.programVariants=new Map);let dt=He.get(Ne);if(dt!==void 0){if(Z.currentProgram===dt&&Z.lightsStateVersion===Le)return Pa(R,Ce),dt}else Ce.uniforms=ce.getUniforms(R),I!==null&&R.isNodeMaterial&&I.build(R,ne,Ce),R.onBeforeCompile(Ce,P),dt=ce.acquireProgram(Ce,Ne),He.set(Ne,dt),Z.uniforms=Ce.uniforms;let Ve=Z.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ve.clippingPlanes=re.uniform),Pa(R,Ce),Z.needsLights=sr(R),Z.lightsStateVersion=Le,Z.needsLights&&(Ve.ambientLightColor.value=Q.state.ambient,Ve.lightProbe.value=Q.state.probe,Ve.sunLights.value=Q.state.sun,Ve.sunLightShadows.value=Q.state.sunShadow,Ve.directionalLights.value=Q.state.directional,Ve.directionalLightShadows.value=Q.state.directionalShadow,Ve.spotLights.value=Q.state.spot,Ve.spotLightShadows.value=Q.state.spotShadow,Ve.rectAreaLights.value=Q.state.rectArea,Ve.ltc_1.value=Q.state.rectAreaLTC1,Ve.ltc_2.value=Q.state.rectAreaLTC2,Ve.pointLights.value=Q.state.point,Ve.pointLightShadows.value=Q.state.pointShadow,Ve.hemisphereLights.value=Q.state.hemi,Ve.sunShadowMatrix.value=Q.state.sunShadowMatrix,Ve.sunShadowCascade.value=Q.state.sunShadowCascade,Ve.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,Ve.spotLightMatrix.value=Q.state.spotLightMatrix,Ve.spotLightMap.value=Q.state.spotLightMap,Ve.pointShadowMatrix.value=Q.state.pointShadowMatrix),Z.numLightProbeGrids=hn(M.state.lightProbeGridArray),Z.currentProgram=dt,Z.uniformsList=null,dt}function gi(R,H,ne,Z,Q){let Ee=We.get(R),Le=Ee.currentProgram.id+","+Z+","+Q,Ce=Ee.programVariants.get(Le);return Ce===void 0?(Ce=cs(R,H,ne),Ee.programVariants.set(Le,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=Z,Ee.toneMapping=Q),Ce}function ir(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=xa.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function Pa(R,H){let ne=We.get(R);ne.outputColorSpace=H.outputColorSpace,ne.batching=H.batching,ne.batchingColor=H.batchingColor,ne.instancing=H.instancing,ne.instancingColor=H.instancingColor,ne.instancingMorph=H.instancingMorph,ne.skinning=H.skinning,ne.morphTargets=H.morphTargets,ne.morphNormals=H.morphNormals,ne.morphColors=H.morphColors,ne.morphTargetsCount=H.morphTargetsCount,ne.numClippingPlanes=H.numClippingPlanes,ne.numIntersection=H.numClipIntersection,ne.vertexAlphas=H.vertexAlphas,ne.vertexTangents=H.vertexTangents,ne.toneMapping=H.toneMapping}function Ia(R,H,ne,Z,Q){H.isScene!==!0&&(H=wn),qe.resetTextureUnits();let Ee=H.fog,Le=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?H.environment:null,Ce=ae===null?P.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:vt.workingColorSpace,Ne=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,He=O.get(Z.envMap||Le,Ne),it=Z.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,dt=!!ne.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ve=!!ne.morphAttributes.position,pt=!!ne.morphAttributes.normal,nn=!!ne.morphAttributes.color,Lt=bs;Z.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Lt=P.toneMapping);let Nt=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,Tn=Nt!==void 0?Nt.length:0,Be=We.get(Z),mn=M.state.lights;if(Wt===!0&&(dn===!0||R!==j)){let Dt=R===j&&Z.id===G;re.setState(Z,R,Dt)}let xt=!1,Ps=!1;Z.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==mn.state.version||Q.isBatchedMesh&&Be.batching===!1||!Q.isBatchedMesh&&Be.batching===!0||Q.isBatchedMesh&&Be.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Be.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Be.instancing===!1||!Q.isInstancedMesh&&Be.instancing===!0||Q.isSkinnedMesh&&Be.skinning===!1||!Q.isSkinnedMesh&&Be.skinning===!0||Q.isInstancedMesh&&Be.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Be.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Be.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Be.instancingMorph===!1&&Q.morphTexture!==null||Be.envMap!==He||Z.fog===!0&&Be.fog!==Ee||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==re.numPlanes||Be.numIntersection!==re.numIntersection)||Be.vertexAlphas!==it||Be.vertexTangents!==dt||Be.morphTargets!==Ve||Be.morphNormals!==pt||Be.morphColors!==nn||Be.morphTargetsCount!==Tn||Be.numLightProbeGrids!==hn(M.state.lightProbeGridArray)?xt=!0:(Be.outputColorSpace!==Ce||Be.toneMapping!==Lt)&&(Ps=!0):(xt=!0,Be.__version=Z.version);let gn=Be.currentProgram;(xt===!0||Ps===!0)&&(gn=Ps===!0?gi(Z,H,Q,Ce,Lt):cs(Z,H,Q),I&&Z.isNodeMaterial&&I.onUpdateProgram(Z,gn,Be));let _o=!1,us=!1,Is=!1,ut=gn.getUniforms(),an=Be.uniforms;if(Te.useProgram(gn.program)&&(_o=!0,us=!0,Is=!0),Z.id!==G&&(G=Z.id,us=!0),_o||j!==R){Te.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ut.setValue(z,"projectionMatrix",R.projectionMatrix),ut.setValue(z,"viewMatrix",R.matrixWorldInverse);let _n=ut.map.cameraPosition;_n!==void 0&&_n.setValue(z,In.setFromMatrixPosition(R.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(z,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ut.setValue(z,"isOrthographic",R.isOrthographicCamera===!0),j!==R&&(j=R,us=!0,Is=!0)}if(Be.needsLights&&(mn.state.sunShadowMap.length>0&&ut.setValue(z,"sunShadowMap",mn.state.sunShadowMap,qe),mn.state.directionalShadowMap.length>0&&ut.setValue(z,"directionalShadowMap",mn.state.directionalShadowMap,qe),mn.state.spotShadowMap.length>0&&ut.setValue(z,"spotShadowMap",mn.state.spotShadowMap,qe),mn.state.pointShadowMap.length>0&&ut.setValue(z,"pointShadowMap",mn.state.pointShadowMap,qe)),Q.isSkinnedMesh){ut.setOptional(z,Q,"bindMatrix"),ut.setOptional(z,Q,"bindMatrixInverse");let Dt=Q.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ut.setValue(z,"boneTexture",Dt.boneTexture,qe))}Q.isBatchedMesh&&(ut.setOptional(z,Q,"batchingTexture"),ut.setValue(z,"batchingTexture",Q._matricesTexture,qe),ut.setOptional(z,Q,"batchingIdTexture"),ut.setValue(z,"batchingIdTexture",Q._indirectTexture,qe),ut.setOptional(z,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ut.setValue(z,"batchingColorTexture",Q._colorsTexture,qe));let ii=ne.morphAttributes;if((ii.position!==void 0||ii.normal!==void 0||ii.color!==void 0)&&oe.update(Q,ne,gn),(us||Be.receiveShadow!==Q.receiveShadow)&&(Be.receiveShadow=Q.receiveShadow,ut.setValue(z,"receiveShadow",Q.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&H.environment!==null&&(an.envMapIntensity.value=H.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=WE()),us){if(ut.setValue(z,"toneMappingExposure",P.toneMappingExposure),Be.needsLights&&mo(an,Is),Ee&&Z.fog===!0&&be.refreshFogUniforms(an,Ee),be.refreshMaterialUniforms(an,Z,xe,ge,M.state.transmissionRenderTarget[R.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Dt=b,_n=0;for(let Xn of M.state.lightProbeGridArray)Xn.texture!==null&&(Dt.textures[_n]=Xn.texture,Dt.min[_n]=Xn.boundingBox.min,Dt.max[_n]=Xn.boundingBox.max,Dt.resolution[_n]=Xn.resolution,_n++);for(let Xn in Dt)Dt[Xn].length=_n;an.probesSH.value=Dt.textures,an.probesMin.value=Dt.min,an.probesMax.value=Dt.max,an.probesResolution.value=Dt.resolution}xa.upload(z,ir(Be),an,qe)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(xa.upload(z,ir(Be),an,qe),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ut.setValue(z,"center",Q.center),ut.setValue(z,"modelViewMatrix",Q.modelViewMatrix),ut.setValue(z,"normalMatrix",Q.normalMatrix),ut.setValue(z,"modelMatrix",Q.matrixWorld),Z.uniformsGroups!==void 0){let Dt=Z.uniformsGroups;for(let _n=0,Xn=Dt.length;_n<Xn;_n++){let Zl=Dt[_n];Xe.update(Zl,gn),Xe.bind(Zl,gn)}}return gn}function mo(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function sr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(R,H,ne){let Z=We.get(R);Z.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),We.get(R.texture).__webglTexture=H,We.get(R.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:ne,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let ne=We.get(R);ne.__webglFramebuffer=H,ne.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,ne=0){ae=R,Y=H,W=ne;let Z=null,Q=!1,Ee=!1;if(R){let Ce=We.get(R);if(Ce.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(z.FRAMEBUFFER,Ce.__webglFramebuffer),te.copy(R.viewport),ue.copy(R.scissor),K=R.scissorTest,Te.viewport(te),Te.scissor(ue),Te.setScissorTest(K),G=-1;return}else if(Ce.__webglFramebuffer===void 0)qe.setupRenderTarget(R);else if(Ce.__hasExternalTextures)qe.rebindTextures(R,We.get(R.texture).__webglTexture,We.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let it=R.depthTexture;if(Ce.__boundDepthTexture!==it){if(it!==null&&We.has(it)&&(R.width!==it.image.width||R.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let He=We.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(He[H])?Z=He[H][ne]:Z=He[H],Q=!0):R.samples>0&&qe.useMultisampledRTT(R)===!1?Z=We.get(R).__webglMultisampledFramebuffer:Array.isArray(He)?Z=He[ne]:Z=He,te.copy(R.viewport),ue.copy(R.scissor),K=R.scissorTest}else te.copy(Ge).multiplyScalar(xe).floor(),ue.copy(ft).multiplyScalar(xe).floor(),K=ct;if(ne!==0&&(Z=U),Te.bindFramebuffer(z.FRAMEBUFFER,Z)&&Te.drawBuffers(R,Z),Te.viewport(te),Te.scissor(ue),Te.setScissorTest(K),Q){let Ce=We.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Ce.__webglTexture,ne)}else if(Ee){let Ce=H;for(let Ne=0;Ne<R.textures.length;Ne++){let He=We.get(R.textures[Ne]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Ne,He.__webglTexture,ne,Ce)}}else if(R!==null&&ne!==0){let Ce=We.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Ce.__webglTexture,ne)}G=-1};function go(R){let H=We.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=at.textureFormatReadable(R.format),H.__typeReadable=at.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,ne,Z,Q,Ee,Le,Ce=0){if(!(R&&R.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Te.bindFramebuffer(z.FRAMEBUFFER,Ne);try{let He=R.textures[Ce],it=He.format,dt=He.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Ce);let Ve=go(He);if(Ve.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Z&&ne>=0&&ne<=R.height-Q&&z.readPixels(H,ne,Z,Q,ve.convert(it),ve.convert(dt),Ee)}finally{let He=ae!==null?We.get(ae).__webglFramebuffer:null;Te.bindFramebuffer(z.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(R,H,ne,Z,Q,Ee,Le,Ce=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(H>=0&&H<=R.width-Z&&ne>=0&&ne<=R.height-Q){Te.bindFramebuffer(z.FRAMEBUFFER,Ne);let He=R.textures[Ce],it=He.format,dt=He.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Ce);let Ve=go(He);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,pt),z.bufferData(z.PIXEL_PACK_BUFFER,Ee.byteLength,z.STREAM_READ),z.readPixels(H,ne,Z,Q,ve.convert(it),ve.convert(dt),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let nn=ae!==null?We.get(ae).__webglFramebuffer:null;Te.bindFramebuffer(z.FRAMEBUFFER,nn);let Lt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await fx(z,Lt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,pt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ee),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(pt),z.deleteSync(Lt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,ne=0){let Z=Math.pow(2,-ne),Q=Math.floor(R.image.width*Z),Ee=Math.floor(R.image.height*Z),Le=H!==null?H.x:0,Ce=H!==null?H.y:0;qe.setTexture2D(R,0),z.copyTexSubImage2D(z.TEXTURE_2D,ne,0,0,Le,Ce,Q,Ee),Te.unbindTexture()},this.copyTextureToTexture=function(R,H,ne=null,Z=null,Q=0,Ee=0){let Le,Ce,Ne,He,it,dt,Ve,pt,nn,Lt=R.isCompressedTexture?R.mipmaps[Ee]:R.image;if(ne!==null)Le=ne.max.x-ne.min.x,Ce=ne.max.y-ne.min.y,Ne=ne.isBox3?ne.max.z-ne.min.z:1,He=ne.min.x,it=ne.min.y,dt=ne.isBox3?ne.min.z:0;else{let ut=Math.pow(2,-Q);Le=Math.floor(Lt.width*ut),Ce=Math.floor(Lt.height*ut),R.isDataArrayTexture?Ne=Lt.depth:R.isData3DTexture?Ne=Math.floor(Lt.depth*ut):Ne=1,He=0,it=0,dt=0}Z!==null?(Ve=Z.x,pt=Z.y,nn=Z.z):(Ve=0,pt=0,nn=0);let Nt=ve.convert(H.format),Tn=ve.convert(H.type),Be;H.isData3DTexture?(qe.setTexture3D(H,0),Be=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(qe.setTexture2DArray(H,0),Be=z.TEXTURE_2D_ARRAY):(qe.setTexture2D(H,0),Be=z.TEXTURE_2D),Te.activeTexture(z.TEXTURE0),Te.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),Te.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Te.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let mn=Te.getParameter(z.UNPACK_ROW_LENGTH),xt=Te.getParameter(z.UNPACK_IMAGE_HEIGHT),Ps=Te.getParameter(z.UNPACK_SKIP_PIXELS),gn=Te.getParameter(z.UNPACK_SKIP_ROWS),_o=Te.getParameter(z.UNPACK_SKIP_IMAGES);Te.pixelStorei(z.UNPACK_ROW_LENGTH,Lt.width),Te.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Lt.height),Te.pixelStorei(z.UNPACK_SKIP_PIXELS,He),Te.pixelStorei(z.UNPACK_SKIP_ROWS,it),Te.pixelStorei(z.UNPACK_SKIP_IMAGES,dt);let us=R.isDataArrayTexture||R.isData3DTexture,Is=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let ut=We.get(R),an=We.get(H),ii=We.get(ut.__renderTarget),Dt=We.get(an.__renderTarget);Te.bindFramebuffer(z.READ_FRAMEBUFFER,ii.__webglFramebuffer),Te.bindFramebuffer(z.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _n=0;_n<Ne;_n++)us&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(R).__webglTexture,Q,dt+_n),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(H).__webglTexture,Ee,nn+_n)),z.blitFramebuffer(He,it,He+Le,it+Ce,Ve,pt,Ve+Le,pt+Ce,z.DEPTH_BUFFER_BIT,z.NEAREST);Te.bindFramebuffer(z.READ_FRAMEBUFFER,null),Te.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||We.has(R)){let ut=We.get(R),an=We.get(H);Te.bindFramebuffer(z.READ_FRAMEBUFFER,D),Te.bindFramebuffer(z.DRAW_FRAMEBUFFER,V);for(let ii=0;ii<Ne;ii++)us?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ut.__webglTexture,Q,dt+ii):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ut.__webglTexture,Q),Is?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,an.__webglTexture,Ee,nn+ii):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,an.__webglTexture,Ee),Q!==0?z.blitFramebuffer(He,it,He+Le,it+Ce,Ve,pt,Ve+Le,pt+Ce,z.COLOR_BUFFER_BIT,z.NEAREST):Is?z.copyTexSubImage3D(Be,Ee,Ve,pt,nn+ii,He,it,Le,Ce):z.copyTexSubImage2D(Be,Ee,Ve,pt,He,it,Le,Ce);Te.bindFramebuffer(z.READ_FRAMEBUFFER,null),Te.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Is?R.isDataTexture||R.isData3DTexture?z.texSubImage3D(Be,Ee,Ve,pt,nn,Le,Ce,Ne,Nt,Tn,Lt.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Be,Ee,Ve,pt,nn,Le,Ce,Ne,Nt,Lt.data):z.texSubImage3D(Be,Ee,Ve,pt,nn,Le,Ce,Ne,Nt,Tn,Lt):R.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ee,Ve,pt,Le,Ce,Nt,Tn,Lt.data):R.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ee,Ve,pt,Lt.width,Lt.height,Nt,Lt.data):z.texSubImage2D(z.TEXTURE_2D,Ee,Ve,pt,Le,Ce,Nt,Tn,Lt);Te.pixelStorei(z.UNPACK_ROW_LENGTH,mn),Te.pixelStorei(z.UNPACK_IMAGE_HEIGHT,xt),Te.pixelStorei(z.UNPACK_SKIP_PIXELS,Ps),Te.pixelStorei(z.UNPACK_SKIP_ROWS,gn),Te.pixelStorei(z.UNPACK_SKIP_IMAGES,_o),Ee===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Be),Te.unbindTexture()},this.initRenderTarget=function(R){We.get(R).__webglFramebuffer===void 0&&qe.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?qe.setTextureCube(R,0):R.isData3DTexture?qe.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?qe.setTexture2DArray(R,0):qe.setTexture2D(R,0),Te.unbindTexture()},this.resetState=function(){Y=0,W=0,ae=null,Te.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var os=new st,Ph=class extends Zr{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,i,s){let r=this,o=new Tl(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},i,s)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(S,b=0){let T=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,M="",p=T.exec(S);p!==null&&(M=p[1]);let w={comments:[],elements:[],headerLength:b,objInfo:""},L=M.split(/\r\n|\r|\n/),P;function N(I,U){let D={type:I[0]};return D.type==="list"?(D.name=I[3],D.countType=I[1],D.itemType=I[2]):D.name=I[1],D.name in U&&(D.name=U[D.name]),D}for(let I=0;I<L.length;I++){let U=L[I];if(U=U.trim(),U==="")continue;let D=U.split(/\s+/),V=D.shift();switch(U=D.join(" "),V){case"format":w.format=D[0],w.version=D[1];break;case"comment":w.comments.push(U);break;case"element":P!==void 0&&w.elements.push(P),P={},P.name=D[0],P.count=parseInt(D[1]),P.properties=[];break;case"property":P.properties.push(N(D,m.propertyNameMapping));break;case"obj_info":w.objInfo=U;break;default:console.log("unhandled",V,D)}}return P!==void 0&&w.elements.push(P),w}function i(S,b){switch(b){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(S);case"float":case"double":case"float32":case"float64":return parseFloat(S)}}function s(S,b){let T={};for(let M=0;M<S.length;M++){if(b.empty())return null;if(S[M].type==="list"){let p=[],w=i(b.next(),S[M].countType);for(let L=0;L<w;L++){if(b.empty())return null;p.push(i(b.next(),S[M].itemType))}T[S[M].name]=p}else T[S[M].name]=i(b.next(),S[M].type)}return T}function r(){let S={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let b of Object.keys(m.customPropertyMapping))S[b]=[];return S}function o(S){switch(S){case"int8":case"char":return fl;case"uint8":case"uchar":return dl;case"int16":case"short":return pl;case"uint16":case"ushort":return Jr;case"int32":case"int":return ml;case"uint32":case"uint":return jr;case"float32":case"float":return Cn;case"float64":case"double":return Rp}}function a(S){switch(S){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(S){return S==="float"||S==="float32"||S==="double"||S==="float64"}function c(S){function b(ae){for(let G of ae){let j=S.find(te=>te.name===G);if(j)return j}return null}let T=b(["x","px","posx"]),M=b(["y","py","posy"]),p=b(["z","pz","posz"]),w=b(["nx","normalx"]),L=b(["ny","normaly"]),P=b(["nz","normalz"]),N=b(["s","u","texture_u","tx"]),I=b(["t","v","texture_v","ty"]),U=b(["red","diffuse_red","r","diffuse_r"]),D=b(["green","diffuse_green","g","diffuse_g"]),V=b(["blue","diffuse_blue","b","diffuse_b"]),Y=b(["texcoord"]),W={};for(let ae of Object.keys(m.customPropertyMapping)){let j=m.customPropertyMapping[ae].map(K=>S.find(q=>q.name===K)),te=j.filter(K=>K).map(K=>K.type),ue=te.length>0&&te.every(K=>K===te[0]);W[ae]={type:ue?te[0]:"float32",usage:j.every(K=>K!==void 0)}}return{position:{names:[T?T.name:"x",M?M.name:"y",p?p.name:"z"],type:T?T.type:"float32",usage:!!(T&&M&&p)},normal:{names:[w?w.name:"nx",L?L.name:"ny",P?P.name:"nz"],type:w?w.type:"float32",usage:!!(w&&L&&P)},uv:{names:[N?N.name:"s",I?I.name:"t"],type:N?N.type:"float32",usage:!!(N&&I)},texcoord:{type:Y?Y.itemType:"float32",usage:!!Y},color:{names:[U?U.name:"red",D?D.name:"green",V?V.name:"blue"],type:U?U.type:"uchar",usage:!!(U&&D&&V)},custom:W}}function u(S,b){let T=r(),M=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,p,w;(w=M.exec(S))!==null?p=w[1].split(/\s+/):p=[];let L=new Pp(p);e:for(let P=0;P<b.elements.length;P++){let N=b.elements[P],I=c(N.properties);T.descriptors[N.name]=I;for(let U=0;U<N.count;U++){let D=s(N.properties,L);if(!D)break e;f(T,N.name,D,I)}}return h(T)}function h(S){let b=new Qn,T=S.descriptors.vertex;S.indices.length>0&&b.setIndex(S.indices);let M=o(T?T.position.type:"float32");if(b.setAttribute("position",new M(S.vertices,3)),S.normals.length>0){let p=o(T.normal.type);b.setAttribute("normal",new p(S.normals,3))}if(S.uvs.length>0){let p=o(T.uv.type);b.setAttribute("uv",new p(S.uvs,2))}if(S.colors.length>0){let p=T.color.type,w=!l(p),L=o(p);b.setAttribute("color",new L(S.colors,3,w))}for(let p of Object.keys(m.customPropertyMapping))if(S[p].length>0){let w=o(T.custom[p].type);b.setAttribute(p,new w(S[p],m.customPropertyMapping[p].length))}if(S.faceVertexUvs.length>0||S.faceVertexColors.length>0){if(b=b.toNonIndexed(),S.faceVertexUvs.length>0){let p=o(S.descriptors.face.texcoord.type);b.setAttribute("uv",new p(S.faceVertexUvs,2))}if(S.faceVertexColors.length>0){let p=S.descriptors.face.color.type,w=!l(p),L=o(p);b.setAttribute("color",new L(S.faceVertexColors,3,w))}}return b.computeBoundingSphere(),b}function f(S,b,T,M){if(b==="vertex"){let{position:p,normal:w,uv:L,color:P}=M;if(p.usage&&S.vertices.push(T[p.names[0]],T[p.names[1]],T[p.names[2]]),w.usage&&S.normals.push(T[w.names[0]],T[w.names[1]],T[w.names[2]]),L.usage&&S.uvs.push(T[L.names[0]],T[L.names[1]]),P.usage){let N=a(P.type),I=l(P.type);os.setRGB(T[P.names[0]]*N,T[P.names[1]]*N,T[P.names[2]]*N,Kn);let U=1/N;S.colors.push(I?os.r:Math.round(os.r*U),I?os.g:Math.round(os.g*U),I?os.b:Math.round(os.b*U))}for(let N of Object.keys(m.customPropertyMapping))for(let I of m.customPropertyMapping[N])S[N].push(T[I])}else if(b==="face"){let p=T.vertex_indices||T.vertex_index,w=T.texcoord;p.length===3?(S.indices.push(p[0],p[1],p[2]),w&&w.length===6&&(S.faceVertexUvs.push(w[0],w[1]),S.faceVertexUvs.push(w[2],w[3]),S.faceVertexUvs.push(w[4],w[5]))):p.length===4&&(S.indices.push(p[0],p[1],p[2]),S.indices.push(p[0],p[2],p[3]),w&&w.length===8&&(S.faceVertexUvs.push(w[0],w[1]),S.faceVertexUvs.push(w[2],w[3]),S.faceVertexUvs.push(w[4],w[5]),S.faceVertexUvs.push(w[0],w[1]),S.faceVertexUvs.push(w[4],w[5]),S.faceVertexUvs.push(w[6],w[7])));let{color:L}=M;if(L.usage){let P=a(L.type);os.setRGB(T[L.names[0]]*P,T[L.names[1]]*P,T[L.names[2]]*P,Kn);let N=1/P,I=os.r*N,U=os.g*N,D=os.b*N;S.faceVertexColors.push(I,U,D),S.faceVertexColors.push(I,U,D),S.faceVertexColors.push(I,U,D),p.length===4&&(S.faceVertexColors.push(I,U,D),S.faceVertexColors.push(I,U,D),S.faceVertexColors.push(I,U,D))}}}function d(S,b){let T={},M=0;for(let p=0;p<b.length;p++){let w=b[p],L=w.valueReader;if(w.type==="list"){let P=[],N=w.countReader.read(S+M);M+=w.countReader.size;for(let I=0;I<N;I++)P.push(L.read(S+M)),M+=L.size;T[w.name]=P}else T[w.name]=L.read(S+M),M+=L.size}return[T,M]}function y(S,b,T){function M(p,w,L){switch(w){case"int8":case"char":return{read:P=>p.getInt8(P),size:1};case"uint8":case"uchar":return{read:P=>p.getUint8(P),size:1};case"int16":case"short":return{read:P=>p.getInt16(P,L),size:2};case"uint16":case"ushort":return{read:P=>p.getUint16(P,L),size:2};case"int32":case"int":return{read:P=>p.getInt32(P,L),size:4};case"uint32":case"uint":return{read:P=>p.getUint32(P,L),size:4};case"float32":case"float":return{read:P=>p.getFloat32(P,L),size:4};case"float64":case"double":return{read:P=>p.getFloat64(P,L),size:8}}}for(let p=0,w=S.length;p<w;p++){let L=S[p];L.type==="list"?(L.countReader=M(b,L.countType,T),L.valueReader=M(b,L.itemType,T)):L.valueReader=M(b,L.type,T)}}function v(S,b){let T=r(),M=b.format==="binary_little_endian",p=new DataView(S,b.headerLength),w,L=0;for(let P=0;P<b.elements.length;P++){let N=b.elements[P],I=N.properties,U=c(I);T.descriptors[N.name]=U,y(I,p,M);for(let D=0;D<N.count;D++){w=d(L,I),L+=w[1];let V=w[0];f(T,N.name,V,U)}}return h(T)}function g(S){let b=0,T=!0,M="",p=[],w=new TextDecoder().decode(S.subarray(0,5)),L=/^ply\r\n/.test(w);do{let P=String.fromCharCode(S[b++]);P!==`
`&&P!=="\r"?M+=P:(M==="end_header"&&(T=!1),M!==""&&(p.push(M),M=""))}while(T&&b<S.length);return L===!0&&b++,{headerText:p.join("\r")+"\r",headerLength:b}}let _,m=this;if(e instanceof ArrayBuffer){let S=new Uint8Array(e),{headerText:b,headerLength:T}=g(S),M=t(b,T);if(M.format==="ascii"){let p=new TextDecoder().decode(S);_=u(p,M)}else _=v(e,M)}else _=u(e,t(e));return _}},Rp=class extends Ft{constructor(e,t,i){super(new Float64Array(e),t,i)}},Pp=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function so(n){for(var e=n.length/6|0,t=new Array(e),i=0;i<e;)t[i]="#"+n.slice(i*6,++i*6);return t}function Ma(n,e,t){n.prototype=e.prototype=t,t.constructor=n}function Xl(n,e){var t=Object.create(n.prototype);for(var i in e)t[i]=e[i];return t}function Er(){}var lo=.7,Sa=1/lo,va="\\s*([+-]?\\d+)\\s*",Hl="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",Ts="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",XE=/^#([0-9a-f]{3,8})$/,$E=new RegExp(`^rgb\\(${va},${va},${va}\\)$`),qE=new RegExp(`^rgb\\(${Ts},${Ts},${Ts}\\)$`),YE=new RegExp(`^rgba\\(${va},${va},${va},${Hl}\\)$`),JE=new RegExp(`^rgba\\(${Ts},${Ts},${Ts},${Hl}\\)$`),jE=new RegExp(`^hsl\\(${Hl},${Ts},${Ts}\\)$`),ZE=new RegExp(`^hsla\\(${Hl},${Ts},${Ts},${Hl}\\)$`),Kx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};Ma(Er,Oh,{copy(n){return Object.assign(new this.constructor,this,n)},displayable(){return this.rgb().displayable()},hex:Qx,formatHex:Qx,formatHex8:KE,formatHsl:QE,formatRgb:ey,toString:ey});function Qx(){return this.rgb().formatHex()}function KE(){return this.rgb().formatHex8()}function QE(){return cy(this).formatHsl()}function ey(){return this.rgb().formatRgb()}function Oh(n){var e,t;return n=(n+"").trim().toLowerCase(),(e=XE.exec(n))?(t=e[1].length,e=parseInt(e[1],16),t===6?ty(e):t===3?new kn(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?Ih(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?Ih(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=$E.exec(n))?new kn(e[1],e[2],e[3],1):(e=qE.exec(n))?new kn(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=YE.exec(n))?Ih(e[1],e[2],e[3],e[4]):(e=JE.exec(n))?Ih(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=jE.exec(n))?sy(e[1],e[2]/100,e[3]/100,1):(e=ZE.exec(n))?sy(e[1],e[2]/100,e[3]/100,e[4]):Kx.hasOwnProperty(n)?ty(Kx[n]):n==="transparent"?new kn(NaN,NaN,NaN,0):null}function ty(n){return new kn(n>>16&255,n>>8&255,n&255,1)}function Ih(n,e,t,i){return i<=0&&(n=e=t=NaN),new kn(n,e,t,i)}function Fp(n){return n instanceof Er||(n=Oh(n)),n?(n=n.rgb(),new kn(n.r,n.g,n.b,n.opacity)):new kn}function $l(n,e,t,i){return arguments.length===1?Fp(n):new kn(n,e,t,i??1)}function kn(n,e,t,i){this.r=+n,this.g=+e,this.b=+t,this.opacity=+i}Ma(kn,$l,Xl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new kn(this.r*n,this.g*n,this.b*n,this.opacity)},darker(n){return n=n==null?lo:Math.pow(lo,n),new kn(this.r*n,this.g*n,this.b*n,this.opacity)},rgb(){return this},clamp(){return new kn(oo(this.r),oo(this.g),oo(this.b),Nh(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:ny,formatHex:ny,formatHex8:eC,formatRgb:iy,toString:iy}));function ny(){return`#${ro(this.r)}${ro(this.g)}${ro(this.b)}`}function eC(){return`#${ro(this.r)}${ro(this.g)}${ro(this.b)}${ro((isNaN(this.opacity)?1:this.opacity)*255)}`}function iy(){let n=Nh(this.opacity);return`${n===1?"rgb(":"rgba("}${oo(this.r)}, ${oo(this.g)}, ${oo(this.b)}${n===1?")":`, ${n})`}`}function Nh(n){return isNaN(n)?1:Math.max(0,Math.min(1,n))}function oo(n){return Math.max(0,Math.min(255,Math.round(n)||0))}function ro(n){return n=oo(n),(n<16?"0":"")+n.toString(16)}function sy(n,e,t,i){return i<=0?n=e=t=NaN:t<=0||t>=1?n=e=NaN:e<=0&&(n=NaN),new as(n,e,t,i)}function cy(n){if(n instanceof as)return new as(n.h,n.s,n.l,n.opacity);if(n instanceof Er||(n=Oh(n)),!n)return new as;if(n instanceof as)return n;n=n.rgb();var e=n.r/255,t=n.g/255,i=n.b/255,s=Math.min(e,t,i),r=Math.max(e,t,i),o=NaN,a=r-s,l=(r+s)/2;return a?(e===r?o=(t-i)/a+(t<i)*6:t===r?o=(i-e)/a+2:o=(e-t)/a+4,a/=l<.5?r+s:2-r-s,o*=60):a=l>0&&l<1?0:o,new as(o,a,l,n.opacity)}function Fh(n,e,t,i){return arguments.length===1?cy(n):new as(n,e,t,i??1)}function as(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}Ma(as,Fh,Xl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new as(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?lo:Math.pow(lo,n),new as(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=this.h%360+(this.h<0)*360,e=isNaN(n)||isNaN(this.s)?0:this.s,t=this.l,i=t+(t<.5?t:1-t)*e,s=2*t-i;return new kn(Ip(n>=240?n-240:n+120,s,i),Ip(n,s,i),Ip(n<120?n+240:n-120,s,i),this.opacity)},clamp(){return new as(ry(this.h),Lh(this.s),Lh(this.l),Nh(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let n=Nh(this.opacity);return`${n===1?"hsl(":"hsla("}${ry(this.h)}, ${Lh(this.s)*100}%, ${Lh(this.l)*100}%${n===1?")":`, ${n})`}`}}));function ry(n){return n=(n||0)%360,n<0?n+360:n}function Lh(n){return Math.max(0,Math.min(1,n||0))}function Ip(n,e,t){return(n<60?e+(t-e)*n/60:n<180?t:n<240?e+(t-e)*(240-n)/60:e)*255}var uy=Math.PI/180,hy=180/Math.PI,Dh=18,fy=.96422,dy=1,py=.82521,my=4/29,ba=6/29,gy=3*ba*ba,tC=ba*ba*ba;function _y(n){if(n instanceof As)return new As(n.l,n.a,n.b,n.opacity);if(n instanceof Qs)return yy(n);n instanceof kn||(n=Fp(n));var e=Op(n.r),t=Op(n.g),i=Op(n.b),s=Lp((.2225045*e+.7168786*t+.0606169*i)/dy),r,o;return e===t&&t===i?r=o=s:(r=Lp((.4360747*e+.3850649*t+.1430804*i)/fy),o=Lp((.0139322*e+.0971045*t+.7141733*i)/py)),new As(116*s-16,500*(r-s),200*(s-o),n.opacity)}function xy(n,e,t,i){return arguments.length===1?_y(n):new As(n,e,t,i??1)}function As(n,e,t,i){this.l=+n,this.a=+e,this.b=+t,this.opacity=+i}Ma(As,xy,Xl(Er,{brighter(n){return new As(this.l+Dh*(n??1),this.a,this.b,this.opacity)},darker(n){return new As(this.l-Dh*(n??1),this.a,this.b,this.opacity)},rgb(){var n=(this.l+16)/116,e=isNaN(this.a)?n:n+this.a/500,t=isNaN(this.b)?n:n-this.b/200;return e=fy*Np(e),n=dy*Np(n),t=py*Np(t),new kn(Dp(3.1338561*e-1.6168667*n-.4906146*t),Dp(-.9787684*e+1.9161415*n+.033454*t),Dp(.0719453*e-.2289914*n+1.4052427*t),this.opacity)}}));function Lp(n){return n>tC?Math.pow(n,1/3):n/gy+my}function Np(n){return n>ba?n*n*n:gy*(n-my)}function Dp(n){return 255*(n<=.0031308?12.92*n:1.055*Math.pow(n,1/2.4)-.055)}function Op(n){return(n/=255)<=.04045?n/12.92:Math.pow((n+.055)/1.055,2.4)}function nC(n){if(n instanceof Qs)return new Qs(n.h,n.c,n.l,n.opacity);if(n instanceof As||(n=_y(n)),n.a===0&&n.b===0)return new Qs(NaN,0<n.l&&n.l<100?0:NaN,n.l,n.opacity);var e=Math.atan2(n.b,n.a)*hy;return new Qs(e<0?e+360:e,Math.sqrt(n.a*n.a+n.b*n.b),n.l,n.opacity)}function Uh(n,e,t,i){return arguments.length===1?nC(n):new Qs(n,e,t,i??1)}function Qs(n,e,t,i){this.h=+n,this.c=+e,this.l=+t,this.opacity=+i}function yy(n){if(isNaN(n.h))return new As(n.l,0,0,n.opacity);var e=n.h*uy;return new As(n.l,Math.cos(e)*n.c,Math.sin(e)*n.c,n.opacity)}Ma(Qs,Uh,Xl(Er,{brighter(n){return new Qs(this.h,this.c,this.l+Dh*(n??1),this.opacity)},darker(n){return new Qs(this.h,this.c,this.l-Dh*(n??1),this.opacity)},rgb(){return yy(this).rgb()}}));var vy=-.14861,Up=1.78277,Bp=-.29227,Bh=-.90649,Wl=1.97294,oy=Wl*Bh,ay=Wl*Up,ly=Up*Bp-Bh*vy;function iC(n){if(n instanceof ao)return new ao(n.h,n.s,n.l,n.opacity);n instanceof kn||(n=Fp(n));var e=n.r/255,t=n.g/255,i=n.b/255,s=(ly*i+oy*e-ay*t)/(ly+oy-ay),r=i-s,o=(Wl*(t-s)-Bp*r)/Bh,a=Math.sqrt(o*o+r*r)/(Wl*s*(1-s)),l=a?Math.atan2(o,r)*hy-120:NaN;return new ao(l<0?l+360:l,a,s,n.opacity)}function kh(n,e,t,i){return arguments.length===1?iC(n):new ao(n,e,t,i??1)}function ao(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}Ma(ao,kh,Xl(Er,{brighter(n){return n=n==null?Sa:Math.pow(Sa,n),new ao(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?lo:Math.pow(lo,n),new ao(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=isNaN(this.h)?0:(this.h+120)*uy,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),i=Math.cos(n),s=Math.sin(n);return new kn(255*(e+t*(vy*i+Up*s)),255*(e+t*(Bp*i+Bh*s)),255*(e+t*(Wl*i)),this.opacity)}}));function My(n,e,t,i,s){var r=n*n,o=r*n;return((1-3*n+3*r-o)*e+(4-6*r+3*o)*t+(1+3*n+3*r-3*o)*i+o*s)/6}function sC(n){var e=n.length-1;return function(t){var i=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=n[i],r=n[i+1],o=i>0?n[i-1]:2*s-r,a=i<e-1?n[i+2]:2*r-s;return My((t-i/e)*e,o,s,r,a)}}function rC(n){var e=n.length;return function(t){var i=Math.floor(((t%=1)<0?++t:t)*e),s=n[(i+e-1)%e],r=n[i%e],o=n[(i+1)%e],a=n[(i+2)%e];return My((t-i/e)*e,s,r,o,a)}}var zp=n=>()=>n;function wy(n,e){return function(t){return n+t*e}}function oC(n,e,t){return n=Math.pow(n,t),e=Math.pow(e,t)-n,t=1/t,function(i){return Math.pow(n+i*e,t)}}function Vp(n,e){var t=e-n;return t?wy(n,t>180||t<-180?t-360*Math.round(t/360):t):zp(isNaN(n)?e:n)}function aC(n){return(n=+n)==1?mi:function(e,t){return t-e?oC(e,t,n):zp(isNaN(e)?t:e)}}function mi(n,e){var t=e-n;return t?wy(n,t):zp(isNaN(n)?e:n)}var WI=(function n(e){var t=aC(e);function i(s,r){var o=t((s=$l(s)).r,(r=$l(r)).r),a=t(s.g,r.g),l=t(s.b,r.b),c=mi(s.opacity,r.opacity);return function(u){return s.r=o(u),s.g=a(u),s.b=l(u),s.opacity=c(u),s+""}}return i.gamma=n,i})(1);function Ty(n){return function(e){var t=e.length,i=new Array(t),s=new Array(t),r=new Array(t),o,a;for(o=0;o<t;++o)a=$l(e[o]),i[o]=a.r||0,s[o]=a.g||0,r[o]=a.b||0;return i=n(i),s=n(s),r=n(r),a.opacity=1,function(l){return a.r=i(l),a.g=s(l),a.b=r(l),a+""}}}var Ay=Ty(sC),XI=Ty(rC);function wa(n,e){return n=+n,e=+e,function(t){return n*(1-t)+e*t}}var lC=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,$I=new RegExp(lC.source,"g");var by=180/Math.PI,kp={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function Ey(n,e,t,i,s,r){var o,a,l;return(o=Math.sqrt(n*n+e*e))&&(n/=o,e/=o),(l=n*t+e*i)&&(t-=n*l,i-=e*l),(a=Math.sqrt(t*t+i*i))&&(t/=a,i/=a,l/=a),n*i<e*t&&(n=-n,e=-e,l=-l,o=-o),{translateX:s,translateY:r,rotate:Math.atan2(e,n)*by,skewX:Math.atan(l)*by,scaleX:o,scaleY:a}}var zh;function cC(n){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(n+"");return e.isIdentity?kp:Ey(e.a,e.b,e.c,e.d,e.e,e.f)}function uC(n){return n==null||(zh||(zh=document.createElementNS("http://www.w3.org/2000/svg","g")),zh.setAttribute("transform",n),!(n=zh.transform.baseVal.consolidate()))?kp:(n=n.matrix,Ey(n.a,n.b,n.c,n.d,n.e,n.f))}function Cy(n,e,t,i){function s(c){return c.length?c.pop()+" ":""}function r(c,u,h,f,d,y){if(c!==h||u!==f){var v=d.push("translate(",null,e,null,t);y.push({i:v-4,x:wa(c,h)},{i:v-2,x:wa(u,f)})}else(h||f)&&d.push("translate("+h+e+f+t)}function o(c,u,h,f){c!==u?(c-u>180?u+=360:u-c>180&&(c+=360),f.push({i:h.push(s(h)+"rotate(",null,i)-2,x:wa(c,u)})):u&&h.push(s(h)+"rotate("+u+i)}function a(c,u,h,f){c!==u?f.push({i:h.push(s(h)+"skewX(",null,i)-2,x:wa(c,u)}):u&&h.push(s(h)+"skewX("+u+i)}function l(c,u,h,f,d,y){if(c!==h||u!==f){var v=d.push(s(d)+"scale(",null,",",null,")");y.push({i:v-4,x:wa(c,h)},{i:v-2,x:wa(u,f)})}else(h!==1||f!==1)&&d.push(s(d)+"scale("+h+","+f+")")}return function(c,u){var h=[],f=[];return c=n(c),u=n(u),r(c.translateX,c.translateY,u.translateX,u.translateY,h,f),o(c.rotate,u.rotate,h,f),a(c.skewX,u.skewX,h,f),l(c.scaleX,c.scaleY,u.scaleX,u.scaleY,h,f),c=u=null,function(d){for(var y=-1,v=f.length,g;++y<v;)h[(g=f[y]).i]=g.x(d);return h.join("")}}}var qI=Cy(cC,"px, ","px)","deg)"),YI=Cy(uC,", ",")",")"),hC=1e-12;function Sy(n){return((n=Math.exp(n))+1/n)/2}function fC(n){return((n=Math.exp(n))-1/n)/2}function dC(n){return((n=Math.exp(2*n))-1)/(n+1)}var JI=(function n(e,t,i){function s(r,o){var a=r[0],l=r[1],c=r[2],u=o[0],h=o[1],f=o[2],d=u-a,y=h-l,v=d*d+y*y,g,_;if(v<hC)_=Math.log(f/c)/e,g=function(p){return[a+p*d,l+p*y,c*Math.exp(e*p*_)]};else{var m=Math.sqrt(v),S=(f*f-c*c+i*v)/(2*c*t*m),b=(f*f-c*c-i*v)/(2*f*t*m),T=Math.log(Math.sqrt(S*S+1)-S),M=Math.log(Math.sqrt(b*b+1)-b);_=(M-T)/e,g=function(p){var w=p*_,L=Sy(T),P=c/(t*m)*(L*dC(e*w+T)-fC(T));return[a+P*d,l+P*y,c*L/Sy(e*w+T)]}}return g.duration=Math.abs(_)*1e3*e/Math.SQRT2,g}return s.rho=function(r){var o=Math.max(.001,+r),a=o*o,l=a*a;return n(o,a,l)},s})(Math.SQRT2,2,4);function Ry(n){return function(e,t){var i=n((e=Fh(e)).h,(t=Fh(t)).h),s=mi(e.s,t.s),r=mi(e.l,t.l),o=mi(e.opacity,t.opacity);return function(a){return e.h=i(a),e.s=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var jI=Ry(Vp),ZI=Ry(mi);function Py(n){return function(e,t){var i=n((e=Uh(e)).h,(t=Uh(t)).h),s=mi(e.c,t.c),r=mi(e.l,t.l),o=mi(e.opacity,t.opacity);return function(a){return e.h=i(a),e.c=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var KI=Py(Vp),QI=Py(mi);function Iy(n){return(function e(t){t=+t;function i(s,r){var o=n((s=kh(s)).h,(r=kh(r)).h),a=mi(s.s,r.s),l=mi(s.l,r.l),c=mi(s.opacity,r.opacity);return function(u){return s.h=o(u),s.s=a(u),s.l=l(Math.pow(u,t)),s.opacity=c(u),s+""}}return i.gamma=e,i})(1)}var eL=Iy(Vp),tL=Iy(mi);var Ly=n=>Ay(n[n.length-1]);var Ny=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(so),Gp=Ly(Ny);function Hp(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-n*(35.34-n*(2381.73-n*(6402.7-n*(7024.72-n*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+n*(170.73+n*(52.82-n*(131.46-n*(176.58-n*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+n*(442.36-n*(2482.43-n*(6167.24-n*(6614.94-n*2475.67)))))))+")"}function Vh(n){var e=n.length;return function(t){return n[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var Wp=Vh(so("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),pC=Vh(so("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),mC=Vh(so("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),gC=Vh(so("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function _C(n){let e=/^#(..)(..)(..)$/.exec(n),t=e?e.slice(1).map(i=>parseInt(i,16)):(n.match(/[\d.]+/g)??[]).map(Number);return[t[0]??0,t[1]??0,t[2]??0]}var ti=256;function tr(n){let e={viridis:Wp,cividis:Hp,blue_red:i=>Gp(1-i)}[n],t=new Uint8Array(4*ti);for(let i=0;i<ti;i++)t.set([..._C(e(i/(ti-1))),255],4*i);return t}var er=[{name:"no outlier",color:[208,212,218]},{name:"too far away after registration",color:[230,159,0]},{name:"its neighbors map elsewhere",color:[0,114,178]},{name:"both",color:[213,94,0]},{name:"the target has nothing there",color:[86,60,92]}];function Dy(){let n=new Uint8Array(4*ti);for(let e=0;e<ti;e++){let t=er[Math.min(er.length-1,Math.floor(e/ti*er.length))];n.set([...t?.color??[0,0,0],255],4*e)}return n}var Oy=([n,e,t])=>`rgb(${n}, ${e}, ${t})`,Fy=n=>(n+.5)/er.length;var ql=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},Uy=10,xC=13,co=32;function Xp(n){}function zy(n){if(typeof n=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=Xp,onError:t=Xp,onRetry:i=Xp,onComment:s,maxBufferSize:r}=n,o=[],a=0,l=!0,c,u="",h=0,f,d=!1;function y(T){if(d)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,T.charCodeAt(0)===239&&T.charCodeAt(1)===187&&T.charCodeAt(2)===191&&(T=T.slice(3))),o.length===0){let w=g(T);w!==""&&(o.push(w),a=w.length),v();return}if(T.indexOf(`
`)===-1&&T.indexOf("\r")===-1){o.push(T),a+=T.length,v();return}o.push(T);let M=o.join("");o.length=0,a=0;let p=g(M);p!==""&&(o.push(p),a=p.length),v()}function v(){r!==void 0&&(a+u.length<=r||(d=!0,o.length=0,a=0,c=void 0,u="",h=0,f=void 0,t(new ql(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function g(T){let M=0;if(T.indexOf("\r")===-1){let p=T.indexOf(`
`,M);for(;p!==-1;){if(M===p){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0,M=p+1,p=T.indexOf(`
`,M);continue}let w=T.charCodeAt(M);if(By(T,M,w)){let L=T.charCodeAt(M+5)===co?M+6:M+5,P=T.slice(L,p);if(h===0&&T.charCodeAt(p+1)===Uy){e({id:c,event:f,data:P}),c=void 0,u="",f=void 0,M=p+2,p=T.indexOf(`
`,M);continue}u=h===0?P:`${u}
${P}`,h++}else ky(T,M,w)?f=T.slice(T.charCodeAt(M+6)===co?M+7:M+6,p)||void 0:_(T,M,p);M=p+1,p=T.indexOf(`
`,M)}return T.slice(M)}for(;M<T.length;){let p=T.indexOf("\r",M),w=T.indexOf(`
`,M),L=-1;if(p!==-1&&w!==-1?L=p<w?p:w:p!==-1?p===T.length-1?L=-1:L=p:w!==-1&&(L=w),L===-1)break;_(T,M,L),M=L+1,T.charCodeAt(M-1)===xC&&T.charCodeAt(M)===Uy&&M++}return T.slice(M)}function _(T,M,p){if(M===p){S();return}let w=T.charCodeAt(M);if(By(T,M,w)){let D=T.charCodeAt(M+5)===co?M+6:M+5,V=T.slice(D,p);u=h===0?V:`${u}
${V}`,h++;return}if(ky(T,M,w)){f=T.slice(T.charCodeAt(M+6)===co?M+7:M+6,p)||void 0;return}if(w===105&&T.charCodeAt(M+1)===100&&T.charCodeAt(M+2)===58){let D=T.slice(T.charCodeAt(M+3)===co?M+4:M+3,p);D.includes("\0")||(c=D);return}if(w===58){if(s){let D=T.slice(M,p);s(D.slice(T.charCodeAt(M+1)===co?2:1))}return}let L=T.slice(M,p),P=L.indexOf(":");if(P===-1){m(L,"",L);return}let N=L.slice(0,P),I=L.charCodeAt(P+1)===co?2:1,U=L.slice(P+I);m(N,U,L)}function m(T,M,p){switch(T){case"event":f=M||void 0;break;case"data":u=h===0?M:`${u}
${M}`,h++;break;case"id":M.includes("\0")||(c=M);break;case"retry":/^\d+$/.test(M)?i(parseInt(M,10)):t(new ql(`Invalid \`retry\` value: "${M}"`,{type:"invalid-retry",value:M,line:p}));break;default:t(new ql(`Unknown field "${T.length>20?`${T.slice(0,20)}…`:T}"`,{type:"unknown-field",field:T,value:M,line:p}));break}}function S(){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0}function b(T={}){if(T.consume&&o.length>0){let M=o.join("");_(M,0,M.length)}l=!0,c=void 0,u="",h=0,f=void 0,o.length=0,a=0,d=!1}return{feed:y,reset:b}}function By(n,e,t){return t===100&&n.charCodeAt(e+1)===97&&n.charCodeAt(e+2)===116&&n.charCodeAt(e+3)===97&&n.charCodeAt(e+4)===58}function ky(n,e,t){return t===101&&n.charCodeAt(e+1)===118&&n.charCodeAt(e+2)===101&&n.charCodeAt(e+3)===110&&n.charCodeAt(e+4)===116&&n.charCodeAt(e+5)===58}var Gh=class extends TransformStream{constructor({onError:e,onRetry:t,onComment:i,maxBufferSize:s}={}){let r;super({start(o){r=zy({onEvent:a=>{o.enqueue(a)},onError(a){typeof e=="function"&&e(a),(e==="terminate"||a.type==="max-buffer-size-exceeded")&&o.error(a)},onRetry:t,onComment:i,maxBufferSize:s})},transform(o){r.feed(o)}})}};function uo(n,e){return!n||n.id!==e.id?e:qn(n.state)&&!qn(e.state)?n:n.cancel_requested&&!e.cancel_requested?{...e,cancel_requested:!0}:e}var Wn=(n,e)=>new Promise(t=>{let i=()=>{clearTimeout(s),e.removeEventListener("abort",i),t()},s=setTimeout(i,n);e.addEventListener("abort",i)}),Ta=n=>n instanceof hi&&n.problem.status<500&&n.problem.status!==429;async function Gi(n,e){for(let t=500;;t=Math.min(t*2,8e3)){try{return await n()}catch(i){if(e.aborted||Ta(i))throw i}await Wn(t,e),e.throwIfAborted()}}var yC=4e4,vC=30;async function Vy(n,e,t){let i,s=0,r=500;for(;!t.aborted;){let o=new AbortController,a=()=>o.abort();t.addEventListener("abort",a,{once:!0});let l=0;try{let c={accept:"text/event-stream"};i!==void 0&&(c["last-event-id"]=i);let u=await Vn(`v1/jobs/${n}/events`,{headers:c,signal:o.signal,cache:"no-store"});if(u.status===204||u.body===null)return;e.connected(!0),r=500;let h=()=>{clearTimeout(l),l=window.setTimeout(a,yC)},f=new TransformStream({transform(_,m){h(),m.enqueue(_)}}),d=new TextDecoderStream,v=u.body.pipeThrough(f).pipeThrough(d).pipeThrough(new Gh).getReader(),g=performance.now();for(;;){let{done:_,value:m}=await v.read();if(_)break;performance.now()-g>vC&&(await Wn(0,o.signal),g=performance.now()),m.id!==void 0&&(i=m.id);let S=JSON.parse(m.data);if(m.event==="trace"){let b=S;b.seq>s&&(s=b.seq,e.trace([b]))}else if(m.event==="progress")e.progress(S.progress??S);else if(e.job(S),m.event==="done")return}}catch(c){if(t.aborted)return;if(Ta(c)){e.failed(c);return}}finally{clearTimeout(l),t.removeEventListener("abort",a)}e.connected(!1),await Wn(r,t),r=Math.min(r*2,8e3)}}async function Gy(n,e,t,i){let s,r=500;for(;!i.aborted;)try{if(s===void 0){let a=await bC(i);await n(),s=a}let o=await Mt(`v1/changes?since=${s}&wait=20`,i);t(!0),r=500,s=o.next_since,o.changes.length>0&&e(o.changes)}catch(o){if(i.aborted||(t(!1),o instanceof hi&&o.problem.status===401))return;await Wn(r,i),r=Math.min(r*2,8e3)}}async function bC(n){let e=async s=>(await Mt(`v1/changes?since=${s}&limit=1`,n)).changes.length>0,[t,i]=[-1,0];for(;await e(i);)[t,i]=[i,Math.max(1,i*4)];for(;i-t>1;){let s=Math.floor((t+i)/2);await e(s)?t=s:i=s}return i}function Aa(n,e=[]){let t=new Ph,i=new TextDecoder().decode(n.slice(0,4096)).split("end_header")[0]??"",s=e.filter(a=>new RegExp(`^property \\w+ ${a}\\s*$`,"m").test(i));t.setCustomPropertyNameMapping(Object.fromEntries(s.map(a=>[a,[a]])));let r=t.parse(n),o={};for(let a of s)o[a]=Float32Array.from(r.getAttribute(a).array),r.deleteAttribute(a);return r.setAttribute("position",new Ft(Float32Array.from(r.getAttribute("position").array),3)),r.computeVertexNormals(),r.computeBoundingSphere(),{geometry:r,rows:o}}var SC=["target","confidence","inlier","spread_mm","outlier","triangle_0","triangle_1","triangle_2","barycentric_0","barycentric_1","barycentric_2"];async function Hy(n,e){let t=`v1/jobs/${n.id}`,i=async a=>(await Vn(`${t}/${a}`,{signal:e})).arrayBuffer(),[s,r,o]=await Promise.all([Gi(()=>Mt(`${t}/result?correspondences=false`,e),e),Gi(()=>i("correspondences?format=ply"),e),Gi(()=>i("surfaces/target?format=ply"),e)]);return{pair:MC(s,r,o),result:s}}function MC(n,e,t){let{geometry:i,rows:s}=Aa(e,SC),{geometry:r}=Aa(t),o=i.getAttribute("position").count,a=new Float32Array(o),l=I=>s[I]??a,[c,u]=[i.getAttribute("position"),r.getAttribute("position")],h=n.transform.matrix.flat(),f=new gt().set(...h),d=[l("triangle_0"),l("triangle_1"),l("triangle_2")],y=[l("barycentric_0"),l("barycentric_1"),l("barycentric_2")],v=new Float32Array(3*o),g=new Int32Array(o),_=l("outlier"),m={confidence:new Float32Array(o),residual:new Float32Array(o),displacement:new Float32Array(o),spread:new Float32Array(o),outlier:new Float32Array(o)},[S,b,T]=[new X,new X,i.getAttribute("normal")];for(let I=0;I<o;I++){let U=_[I]===4;for(let D=0;D<3;D++){let V=0;for(let Y=0;Y<3;Y++)V+=(y[Y]?.[I]??0)*u.getComponent(d[Y]?.[I]??0,D);v[3*I+D]=V}g[I]=U?-1:l("target")[I]??-1,S.fromBufferAttribute(c,I).applyMatrix4(f),b.fromBufferAttribute(T,I).transformDirection(f),S.set(v[3*I]-S.x,v[3*I+1]-S.y,v[3*I+2]-S.z),m.confidence[I]=U?NaN:l("confidence")[I]??NaN,m.spread[I]=U?NaN:l("spread_mm")[I]??NaN,m.residual[I]=U?NaN:S.length(),m.displacement[I]=U?NaN:S.dot(b),m.outlier[I]=Fy(_[I]??0)}let M=Object.fromEntries(Object.keys(m).map(I=>[I,wC(m[I],I==="outlier",d,y,g,r)])),p=u.count,w=new Uint32Array(p+1);g.forEach(I=>I>=0&&w[I+1]++);for(let I=0;I<p;I++)w[I+1]+=w[I];let L=w.slice(0,p),P=new Uint32Array(w[p]);g.forEach((I,U)=>I>=0&&(P[L[I]++]=U));let N=Uint8Array.from(l("inlier"));return{source:i,target:r,targetFromSource:f,images:v,nearest:g,inlier:N,columns:m,onTarget:M,starts:w,sources:P,frame:Es(r)}}function wC(n,e,t,i,s,r){let o=r.getAttribute("position").count,a=new Float32Array(o).fill(NaN);if(e)s.forEach((c,u)=>c>=0&&(a[c]=Math.max(Number.isNaN(a[c])?0:a[c],n[u])));else{let[c,u]=[new Float64Array(o),new Float64Array(o)];for(let h=0;h<n.length;h++)if(!Number.isNaN(n[h]))for(let f=0;f<3;f++){let[d,y]=[t[f][h],i[f][h]];c[d]+=y*n[h],u[d]+=y}for(let h=0;h<o;h++)u[h]>1e-9&&(a[h]=c[h]/u[h])}let l=r.getIndex();for(let c=0;c<2;c++){let[u,h]=[new Float64Array(o),new Uint16Array(o)];for(let f=0;f<l.count;f+=3)for(let d=0;d<3;d++){let y=a[l.getX(f+d)];if(!Number.isNaN(y))for(let v=0;v<3;v++){let g=l.getX(f+v);u[g]=e?Math.max(u[g],y):u[g]+y,h[g]++}}for(let f=0;f<o;f++)Number.isNaN(a[f])&&h[f]>0&&(a[f]=e?u[f]:u[f]/h[f])}return a}function Es(n){let e=n.getAttribute("position"),t=new X,i=new X;for(let h=0;h<e.count;h++)t.add(i.fromBufferAttribute(e,h));t.divideScalar(Math.max(1,e.count));let s=[0,0,0,0,0,0,0,0,0];for(let h=0;h<e.count;h++){let f=i.fromBufferAttribute(e,h).sub(t).toArray();for(let d=0;d<3;d++)for(let y=0;y<3;y++)s[3*d+y]+=f[d]*f[y]}let r=[1,0,0,0,1,0,0,0,1];for(let h=0;h<12;h++)for(let[f,d]of[[0,1],[0,2],[1,2]]){let y=s[3*f+d];if(Math.abs(y)<1e-12)continue;let v=.5*Math.atan2(2*y,s[3*d+d]-s[3*f+f]),[g,_]=[Math.cos(v),Math.sin(v)];for(let m=0;m<3;m++){let[S,b]=[s[3*m+f],s[3*m+d]];s[3*m+f]=g*S-_*b,s[3*m+d]=_*S+g*b}for(let m=0;m<3;m++){let[S,b]=[s[3*f+m],s[3*d+m]];s[3*f+m]=g*S-_*b,s[3*d+m]=_*S+g*b;let[T,M]=[r[3*m+f],r[3*m+d]];r[3*m+f]=g*T-_*M,r[3*m+d]=_*T+g*M}}let o=[0,1,2].sort((h,f)=>s[4*f]-s[4*h]),a=h=>new X(r[o[h]],r[3+o[h]],r[6+o[h]]).normalize(),[l,c]=[a(0),a(1)],u=[l,c,new X().crossVectors(l,c)];return Wy(n,t,u)}function Wy(n,e,t){let i=n.getAttribute("position"),[s,r]=[new X(1/0,1/0,1/0),new X(-1/0,-1/0,-1/0)],[o,a]=[new X,new X];for(let l=0;l<i.count;l++)o.fromBufferAttribute(i,l).sub(e),a.set(o.dot(t[0]),o.dot(t[1]),o.dot(t[2])),s.min(a),r.max(a);return{center:e,axes:t,low:s,high:r}}function Xy(n,e){let t=Es(e),[i,s]=[n.getAttribute("position"),e.getAttribute("position")];if(i.count!==s.count)return Es(n);let r=new X,[o,a]=[new X,new X];for(let u=0;u<i.count;u++)r.add(o.fromBufferAttribute(i,u));r.divideScalar(Math.max(1,i.count));let l=[0,0,0,0,0,0,0,0,0];for(let u=0;u<i.count;u++){let[h,f]=[o.fromBufferAttribute(i,u).sub(r).toArray(),a.fromBufferAttribute(s,u).sub(t.center).toArray()];for(let d=0;d<3;d++)for(let y=0;y<3;y++)l[3*d+y]+=h[d]*f[y]}let c=new nt().set(...l);c.multiplyScalar(1/(Math.cbrt(Math.abs(c.determinant()))||1));for(let u=0;u<30;u++){let h=c.clone().invert().transpose();for(let f=0;f<9;f++)c.elements[f]=(c.elements[f]+h.elements[f])/2}return Math.abs(c.determinant()-1)<.01?Wy(n,r,t.axes.map(u=>u.clone().applyMatrix3(c))):Es(n)}function $p(n,e,t){let i=e.length/3,s=new Float32Array(3*i),r=new X,o=Math.max(1e-9,n.high.x-n.low.x);for(let a=0;a<i;a++)r.set(e[3*a],e[3*a+1],e[3*a+2]).sub(n.center),s[3*a]=t(a)?(r.dot(n.axes[0])-n.low.x)/o:-1,s[3*a+1]=r.dot(n.axes[1]),s[3*a+2]=r.dot(n.axes[2]);return new Ft(s,3)}function Hh(n,e){let t=n.filter(i=>!Number.isNaN(i)).sort();return t[Math.min(t.length-1,Math.floor(e*t.length))]??1}var qp={type:"change"},jp={type:"start"},Zp={type:"end"},Wh=1e-6,Rt={NONE:-1,ROTATE:0,ZOOM:1,PAN:2,TOUCH_ROTATE:3,TOUCH_ZOOM_PAN:4},Xh=new Ke,Cr=new Ke,TC=new X,$h=new X,Yp=new X,Rr=new Sn,qh=new X,Yh=new X,Jp=new X,Jh=new X,Pr=class extends Pl{constructor(e,t=null){super(e,t),this.screen={left:0,top:0,width:0,height:0},this.rotateSpeed=1,this.zoomSpeed=1.2,this.panSpeed=.3,this.rollSpeed=1,this.noRotate=!1,this.noZoom=!1,this.noPan=!1,this.multiTouchRoll=!1,this.staticMoving=!1,this.dynamicDampingFactor=.2,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.keys=["KeyA","KeyS","KeyD"],this.mouseButtons={LEFT:wr.ROTATE,MIDDLE:wr.DOLLY,RIGHT:wr.PAN},this.target=new X,this.state=Rt.NONE,this.keyState=Rt.NONE,this._lastPosition=new X,this._lastUp=new X,this._lastZoom=1,this._touchZoomDistanceStart=0,this._touchZoomDistanceEnd=0,this._touchRollAngle=0,this._touchRollPointerIds="",this._lastAngle=0,this._lastRollAngle=0,this._eye=new X,this._movePrev=new Ke,this._moveCurr=new Ke,this._lastAxis=new X,this._zoomStart=new Ke,this._zoomEnd=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._pointers=[],this._pointerPositions={},this._onPointerMove=EC.bind(this),this._onPointerDown=AC.bind(this),this._onPointerUp=CC.bind(this),this._onPointerCancel=RC.bind(this),this._onContextMenu=FC.bind(this),this._onMouseWheel=OC.bind(this),this._onKeyDown=IC.bind(this),this._onKeyUp=PC.bind(this),this._onTouchStart=UC.bind(this),this._onTouchMove=BC.bind(this),this._onTouchEnd=kC.bind(this),this._onMouseDown=LC.bind(this),this._onMouseMove=NC.bind(this),this._onMouseUp=DC.bind(this),this._target0=this.target.clone(),this._position0=this.object.position.clone(),this._up0=this.object.up.clone(),this._zoom0=this.object.zoom,t!==null&&(this.connect(t),this.handleResize()),this.update()}connect(e){super.connect(e),window.addEventListener("keydown",this._onKeyDown),window.addEventListener("keyup",this._onKeyUp),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerCancel),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction="none"}disconnect(){window.removeEventListener("keydown",this._onKeyDown),window.removeEventListener("keyup",this._onKeyUp),this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerCancel),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction=""}dispose(){this.disconnect()}handleResize(){let e=this.domElement.getBoundingClientRect(),t=this.domElement.ownerDocument.documentElement;this.screen.left=e.left+window.pageXOffset-t.clientLeft,this.screen.top=e.top+window.pageYOffset-t.clientTop,this.screen.width=e.width,this.screen.height=e.height}update(){if(this._eye.subVectors(this.object.position,this.target),this.noRotate||(this._rotateCamera(),this.multiTouchRoll===!0&&this._rollCamera()),this.noZoom||this._zoomCamera(),this.noPan||this._panCamera(),this.object.position.addVectors(this.target,this._eye),this.object.isPerspectiveCamera){this._checkDistances(),this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Wh,t=this._lastUp.distanceToSquared(this.object.up)>Wh;(e||t)&&(this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up))}else if(this.object.isOrthographicCamera){this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Wh,t=this._lastUp.distanceToSquared(this.object.up)>Wh,i=this._lastZoom!==this.object.zoom;(e||t||i)&&(this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom)}else console.warn("THREE.TrackballControls: Unsupported camera type.")}reset(){this.state=Rt.NONE,this.keyState=Rt.NONE,this.target.copy(this._target0),this.object.position.copy(this._position0),this.object.up.copy(this._up0),this.object.zoom=this._zoom0,this.object.updateProjectionMatrix(),this._eye.subVectors(this.object.position,this.target),this.object.lookAt(this.target),this.dispatchEvent(qp),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom}_panCamera(){if(Cr.copy(this._panEnd).sub(this._panStart),Cr.lengthSq()){if(this.object.isOrthographicCamera){let e=(this.object.right-this.object.left)/this.object.zoom/this.domElement.clientWidth,t=(this.object.top-this.object.bottom)/this.object.zoom/this.domElement.clientWidth;Cr.x*=e,Cr.y*=t}Cr.multiplyScalar(this._eye.length()*this.panSpeed),$h.copy(this._eye).cross(this.object.up).setLength(Cr.x),$h.add(TC.copy(this.object.up).setLength(Cr.y)),this.object.position.add($h),this.target.add($h),this.staticMoving?this._panStart.copy(this._panEnd):this._panStart.add(Cr.subVectors(this._panEnd,this._panStart).multiplyScalar(this.dynamicDampingFactor))}}_rotateCamera(){Jh.set(this._moveCurr.x-this._movePrev.x,this._moveCurr.y-this._movePrev.y,0);let e=Jh.length();e?(this._eye.copy(this.object.position).sub(this.target),qh.copy(this._eye).normalize(),Yh.copy(this.object.up).normalize(),Jp.crossVectors(Yh,qh).normalize(),Yh.setLength(this._moveCurr.y-this._movePrev.y),Jp.setLength(this._moveCurr.x-this._movePrev.x),Jh.copy(Yh.add(Jp)),Yp.crossVectors(Jh,this._eye).normalize(),e*=this.rotateSpeed,Rr.setFromAxisAngle(Yp,e),this._eye.applyQuaternion(Rr),this.object.up.applyQuaternion(Rr),this._lastAxis.copy(Yp),this._lastAngle=e):!this.staticMoving&&this._lastAngle&&(this._lastAngle*=Math.sqrt(1-this.dynamicDampingFactor),this._eye.copy(this.object.position).sub(this.target),Rr.setFromAxisAngle(this._lastAxis,this._lastAngle),this._eye.applyQuaternion(Rr),this.object.up.applyQuaternion(Rr)),this._movePrev.copy(this._moveCurr)}_rollCamera(){let e=this._getTouchRollAngle();if(e)this._lastRollAngle=e*this.rollSpeed;else if(!this.staticMoving&&this._lastRollAngle)this._lastRollAngle*=Math.sqrt(1-this.dynamicDampingFactor);else return;qh.copy(this._eye).normalize(),Rr.setFromAxisAngle(qh,this._lastRollAngle),this.object.up.applyQuaternion(Rr)}_getTouchRollAngle(){let e=this._pointers[0],t=this._pointers[1];if(t===void 0||e.pointerType!=="touch"||t.pointerType!=="touch")return this._touchRollPointerIds="",0;let i=`${e.pointerId},${t.pointerId}`,s=this._pointerPositions[e.pointerId],r=this._pointerPositions[t.pointerId],o=Math.atan2(r.y-s.y,r.x-s.x);if(i!==this._touchRollPointerIds)return this._touchRollPointerIds=i,this._touchRollAngle=o,0;let a=o-this._touchRollAngle;return this._touchRollAngle=o,a>Math.PI?a-=2*Math.PI:a<-Math.PI&&(a+=2*Math.PI),a}_zoomCamera(){let e;this.state===Rt.TOUCH_ZOOM_PAN?(e=this._touchZoomDistanceStart/this._touchZoomDistanceEnd,this._touchZoomDistanceStart=this._touchZoomDistanceEnd,this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=wh.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")):(e=1+(this._zoomEnd.y-this._zoomStart.y)*this.zoomSpeed,e!==1&&e>0&&(this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=wh.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")),this.staticMoving?this._zoomStart.copy(this._zoomEnd):this._zoomStart.y+=(this._zoomEnd.y-this._zoomStart.y)*this.dynamicDampingFactor)}_getMouseOnScreen(e,t){return Xh.set((e-this.screen.left)/this.screen.width,(t-this.screen.top)/this.screen.height),Xh}_getMouseOnCircle(e,t){return Xh.set((e-this.screen.width*.5-this.screen.left)/(this.screen.width*.5),(this.screen.height+2*(this.screen.top-t))/this.screen.width),Xh}_addPointer(e){this._pointers.push(e)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t].pointerId==e.pointerId){this._pointers.splice(t,1);return}}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0].pointerId?this._pointers[1]:this._pointers[0];return this._pointerPositions[t.pointerId]}_checkDistances(){(!this.noZoom||!this.noPan)&&(this._eye.lengthSq()>this.maxDistance*this.maxDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.maxDistance)),this._zoomStart.copy(this._zoomEnd)),this._eye.lengthSq()<this.minDistance*this.minDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.minDistance)),this._zoomStart.copy(this._zoomEnd)))}};function AC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n))}function EC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function CC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchEnd(n):this._onMouseUp(),this._removePointer(n),this._pointers.length===0&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp)))}function RC(n){this._removePointer(n)}function PC(){this.enabled!==!1&&(this.keyState=Rt.NONE,window.addEventListener("keydown",this._onKeyDown))}function IC(n){this.enabled!==!1&&(window.removeEventListener("keydown",this._onKeyDown),this.keyState===Rt.NONE&&(n.code===this.keys[Rt.ROTATE]&&!this.noRotate?this.keyState=Rt.ROTATE:n.code===this.keys[Rt.ZOOM]&&!this.noZoom?this.keyState=Rt.ZOOM:n.code===this.keys[Rt.PAN]&&!this.noPan&&(this.keyState=Rt.PAN)))}function LC(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case wr.DOLLY:this.state=Rt.ZOOM;break;case wr.ROTATE:this.state=Rt.ROTATE;break;case wr.PAN:this.state=Rt.PAN;break;default:this.state=Rt.NONE}let t=this.keyState!==Rt.NONE?this.keyState:this.state;t===Rt.ROTATE&&!this.noRotate?(this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr)):t===Rt.ZOOM&&!this.noZoom?(this._zoomStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._zoomEnd.copy(this._zoomStart)):t===Rt.PAN&&!this.noPan&&(this._panStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._panEnd.copy(this._panStart)),this.dispatchEvent(jp)}function NC(n){let e=this.keyState!==Rt.NONE?this.keyState:this.state;e===Rt.ROTATE&&!this.noRotate?this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)):e===Rt.ZOOM&&!this.noZoom?this._zoomEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY)):e===Rt.PAN&&!this.noPan&&this._panEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY))}function DC(){this.state=Rt.NONE,this.dispatchEvent(Zp)}function OC(n){if(this.enabled!==!1&&this.noZoom!==!0){switch(n.preventDefault(),n.deltaMode){case 2:this._zoomStart.y-=n.deltaY*.025;break;case 1:this._zoomStart.y-=n.deltaY*.01;break;default:this._zoomStart.y-=n.deltaY*25e-5;break}this.dispatchEvent(jp),this.dispatchEvent(Zp)}}function FC(n){this.enabled!==!1&&n.preventDefault()}function UC(n){if(this._trackPointer(n),this._pointers.length===1)this.state=Rt.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(this._pointers[0].pageX,this._pointers[0].pageY)),this._movePrev.copy(this._moveCurr);else{this.state=Rt.TOUCH_ZOOM_PAN;let e=this._pointers[0].pageX-this._pointers[1].pageX,t=this._pointers[0].pageY-this._pointers[1].pageY;this._touchZoomDistanceEnd=this._touchZoomDistanceStart=Math.sqrt(e*e+t*t);let i=(this._pointers[0].pageX+this._pointers[1].pageX)/2,s=(this._pointers[0].pageY+this._pointers[1].pageY)/2;this._panStart.copy(this._getMouseOnScreen(i,s)),this._panEnd.copy(this._panStart)}this.dispatchEvent(jp)}function BC(n){if(this._trackPointer(n),this._pointers.length===1)this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY));else{let e=this._getSecondPointerPosition(n),t=n.pageX-e.x,i=n.pageY-e.y;this._touchZoomDistanceEnd=Math.sqrt(t*t+i*i);let s=(n.pageX+e.x)/2,r=(n.pageY+e.y)/2;this._panEnd.copy(this._getMouseOnScreen(s,r))}}function kC(n){switch(this._pointers.length){case 0:this.state=Rt.NONE;break;case 1:this.state=Rt.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr);break;case 2:this.state=Rt.TOUCH_ZOOM_PAN;for(let e=0;e<this._pointers.length;e++)if(this._pointers[e].pointerId!==n.pointerId){let t=this._pointerPositions[this._pointers[e].pointerId];this._moveCurr.copy(this._getMouseOnCircle(t.x,t.y)),this._movePrev.copy(this._moveCurr);break}break}this.dispatchEvent(Zp)}var zC=`
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
  }`,VC=`
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
  }`,Kp=new kt(0,0,0,1);function jh(n){let e={map:{value:n},low:{value:0},top:{value:1},opacity:{value:1},byPlace:{value:!0},grid:{value:!0},section:{value:Kp.clone()},pose:{value:new gt}};return new zi({vertexShader:zC,fragmentShader:VC,uniforms:e,side:di})}function $y(n){let e=new Ys(tr(n),ti,1);return e.needsUpdate=!0,e}function Qp(n){let e=n.getAttribute("position").count;n.hasAttribute("value")||n.setAttribute("value",new Ft(new Float32Array(e).fill(-1e9),1));let t=jh($y("viridis"));return t.uniforms.byPlace.value=!1,t.uniforms.grid.value=!1,new Mn(n,t)}function em(n,{values:e,low:t,high:i,map:s}){let{uniforms:r}=n.material;r.map.value.dispose(),r.map.value=$y(s),r.low.value=t,r.top.value=Math.max(i,t+1e-12);let o=n.geometry.getAttribute("value");for(let a=0;a<o.count;a++)o.array[a]=Number.isFinite(e[a])?e[a]:-1e9;o.needsUpdate=!0}function tm(n,e,t){n.up.copy(e.axes[1]),n.position.copy(e.center).addScaledVector(e.axes[2],4*t),[n.near,n.far,n.zoom]=[-20*t,40*t,1],n.lookAt(e.center)}function nm(n,e,t,i){let{low:s,high:r}=e,o=Math.max(2.2*Math.max(-s.x,r.x)/t,2.3*Math.max(-s.y,r.y,-s.z,r.z)/i);[n.left,n.right,n.top,n.bottom]=[-t,t,i,-i].map(a=>a*o/2),n.updateProjectionMatrix()}var Zh=class{constructor(e,t){this.canvas=e;this.renderer=new ws({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.mesh=Qp(t),this.mesh.frustumCulled=!1,this.scene.add(this.mesh),this.frame=Es(t),this.radius=t.boundingSphere?.radius||1,this.controls=new Pr(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.sizes.observe(e);let i=()=>{this.waiting=requestAnimationFrame(i),this.controls.update(),this.isDirty&&this.draw()};i()}canvas;renderer;camera=new Ii;controls;scene=new ns;mesh;frame;radius;sizes=new ResizeObserver(()=>this.resize());waiting=0;isDirty=!0;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose(),this.renderer.dispose()}color(e){em(this.mesh,e),this.redraw()}move(e){let t=this.mesh.geometry.getAttribute("position");t.array.set(e),t.needsUpdate=!0,this.mesh.geometry.computeVertexNormals(),this.mesh.geometry.computeBoundingSphere(),this.redraw()}view(){this.controls.target.copy(this.frame.center),tm(this.camera,this.frame,this.radius),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new X().crossVectors(this.camera.up,i).normalize(),r=new Sn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new Sn().setFromAxisAngle(s,t)),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i.applyQuaternion(r)),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}redraw(){this.isDirty=!0}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),nm(this.camera,this.frame,e,t),this.controls.handleResize(),this.redraw())}draw(){this.isDirty=!1,this.renderer.setClearColor(new st(getComputedStyle(this.canvas).getPropertyValue("--canvas").trim()||"#f4f6f8")),this.renderer.render(this.scene,this.camera)}pick(e,t){let i=new Kr,{clientWidth:s,clientHeight:r}=this.canvas;this.camera.updateMatrixWorld(),i.setFromCamera(new Ke(2*e/s-1,1-2*t/r),this.camera);let o=i.intersectObject(this.mesh)[0];if(!o?.face)return null;let a=this.mesh.geometry.getAttribute("position"),l=c=>o.point.distanceToSquared(new X().fromBufferAttribute(a,c));return[o.face.a,o.face.b,o.face.c].reduce((c,u)=>l(u)<l(c)?u:c)}project(e){this.camera.updateMatrixWorld();let{geometry:t}=this.mesh,i=new X().fromBufferAttribute(t.getAttribute("position"),e).project(this.camera),s=new X().fromBufferAttribute(t.getAttribute("normal"),e),r=new X().setFromMatrixColumn(this.camera.matrixWorld,2);return{x:(i.x+1)/2*this.canvas.clientWidth,y:(1-i.y)/2*this.canvas.clientHeight,facing:s.dot(r)}}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var[im,sm]=[88,40],GC=500,HC=250,nr,Ea=new Map,qy=Promise.resolve();function WC({geometry:n,coloring:e,frame:t=Es(n)}){if(nr===void 0)try{nr=new ws({antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),nr.setPixelRatio(2),nr.setSize(im,sm,!1)}catch{nr=null}if(nr===null)return null;let[i,s,r]=[Qp(n),new ns,new Ii];return e&&em(i,e),s.add(i),tm(r,t,n.boundingSphere?.radius||1),nm(r,t,im,sm),nr.setClearColor(0,0),nr.render(s,r),i.material.uniforms.map.value.dispose(),i.material.dispose(),n.dispose(),nr.domElement.toDataURL()}function Kh({name:n,alt:e,load:t}){let i=Xt(null),[s,r]=pe(!1),[o,a]=pe(Ea.get(n)??null);return mt(()=>{let l=0,c=new IntersectionObserver(u=>{clearTimeout(l),u.at(-1).isIntersecting&&(l=window.setTimeout(()=>r(!0),HC))});return c.observe(i.current),()=>{clearTimeout(l),c.disconnect()}},[]),sn(l=>{a(Ea.get(n)??null),!(!s||Ea.has(n))&&(qy=qy.then(async()=>{if(l.aborted)return;let c=await t(l).catch(()=>null),u=c===null||l.aborted?null:WC(c);u!==null&&(Ea.size>=GC&&Ea.clear(),Ea.set(n,u),a(u))}))},[n,s]),x("span",{class:"picture",ref:i,children:o!==null&&x("img",{src:o,width:im,height:sm,alt:e})})}var Yl=new Map,XC=2e3;function Yy({id:n,state:e}){let[t,i]=pe(Yl.get(n)??[]);if(sn(l=>{let c=Yl.get(n);i(c??[]),!(e==="queued"||c!==void 0&&qn(e))&&Wn(250,l).then(async()=>{if(l.aborted)return;let u=await Mt(`v1/jobs/${n}/trace?limit=200`,l).catch(()=>null);if(u===null)return;let h=u.points.filter(Ba),d=(h.length>0?h:u.points.filter(({phase:y})=>y==="inference")).flatMap(({energy:y})=>y===void 0?[]:[y]);Yl.size>XC&&Yl.clear(),qn(e)&&Yl.set(n,d),i(d)})},[n,e]),t.length<2)return null;let s=t.map(l=>Math.log(Math.max(l,1e-9))),[r,o]=[Math.min(...s),Math.max(...s)],a=s.map((l,c)=>`${(c/(s.length-1)*78+1).toFixed(1)},${(21-20*(l-r)/(o-r||1)).toFixed(1)}`);return x("svg",{class:"spark",width:"80",height:"22",role:"img","aria-label":`Energy from ${t[0].toPrecision(3)} to ${t.at(-1).toPrecision(3)}`,children:x("polyline",{points:a.join(" ")})})}var $C=44;function qC(n,e){let[,t]=pe(0),i=Xt(null),s={count:n,getScrollElement:()=>e.current,estimateSize:()=>$C,overscan:8,scrollToFn:j0,observeElementRect:Y0,observeElementOffset:J0,onChange:()=>t(r=>r+1)};return i.current??=new Nc(s),i.current.setOptions(s),mt(()=>i.current._didMount(),[]),mt(()=>i.current._willUpdate()),i.current}async function YC({id:n,pictured:e},t){let i=await(await Vn(`v1/jobs/${n}/surfaces/${e}?format=ply`,{signal:t})).arrayBuffer();return{geometry:Aa(i).geometry}}function rm({labels:n}){let{source_file:e,target_file:t}=n;return e&&t?`${e} → ${t}`:e??t??""}function Jy({rows:n,pictures:e,hasMore:t,more:i,renew:s,failed:r}){let o=Xt(null),a=qC(n.length,o),l=Ui(),c=a.getVirtualItems(),u=c.at(-1)?.index??0;mt(()=>{u>=n.length-12&&i?.()},[i===null,u,n.length]);let h=(_,m)=>{$n("POST",`v1/jobs/${m}/${_}`).then(S=>_==="retry"?ji(`jobs/${S.id}`):s([m]),r)},f=(_,m)=>$n("PATCH",`v1/jobs/${_}`,{priority:m}).then(()=>s([_]),r),d=_=>{if(_.ctrlKey||_.altKey||_.metaKey)return;let m={ArrowDown:1,j:1,ArrowUp:-1,k:-1,PageDown:12,PageUp:-12}[_.key],S=_.target;if(m===void 0||S.tagName==="INPUT")return;let b=Number(S.closest("tr")?.dataset.index??-1),T=Math.min(n.length-1,Math.max(0,b+m));_.preventDefault(),a.scrollToIndex(T);let M=p=>{let w=o.current?.querySelector(`tr[data-index="${T}"] a`);w?w.focus():p>0&&requestAnimationFrame(()=>M(p-1))};requestAnimationFrame(()=>M(10))},y=Xt(d);y.current=d,mt(()=>{let _=m=>(m.target===document.body||m.target===document.getElementById("main"))&&y.current(m);return window.addEventListener("keydown",_),()=>window.removeEventListener("keydown",_)},[]);let v=c[0]?.start??0,g=Math.max(0,a.getTotalSize()-(c.at(-1)?.end??0));return x("div",{class:"rows",ref:o,onKeyDown:d,tabIndex:0,role:"region","aria-label":"Jobs; arrow keys move from row to row, Enter opens one",children:x("table",{"aria-rowcount":t?-1:n.length+1,children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Job"}),e&&x("th",{scope:"col",children:"Shape"}),x("th",{scope:"col",children:"State"}),x("th",{scope:"col",children:"Verdict"}),x("th",{scope:"col",class:"numeric",children:"Distance"}),x("th",{scope:"col",children:"Energy"}),x("th",{scope:"col",children:"Method"}),x("th",{scope:"col",children:"Age"}),x("th",{scope:"col",children:"Ran for"}),x("th",{scope:"col",children:"Priority"}),x("th",{scope:"col",children:x("span",{class:"quiet",children:"Actions"})})]})}),x("tbody",{children:[v>0&&x("tr",{"aria-hidden":"true",style:{height:`${v}px`}}),c.map(({index:_})=>{let m=n[_];if(m===void 0)return null;let S=mc(m);return x("tr",{"data-index":_,"data-state":m.state,"aria-rowindex":_+2,children:[x("td",{children:[x("a",{href:`#/jobs/${m.id}`,title:m.id,children:x("code",{children:["…",Yn(m.id)]})})," ",m.external_ref&&x("span",{class:"soft",children:m.external_ref}),rm(m)!==""&&x("span",{class:"soft files",title:rm(m),children:rm(m)}),m.batch_id&&x("a",{class:"soft",href:`#/batches/${m.batch_id}`,children:"batch"}),m.study_id&&x("a",{class:"soft",href:`#/studies/${m.study_id}`,children:"study"})]}),e&&x("td",{children:m.state==="succeeded"&&m.pictured&&x(Kh,{name:`job/${m.id}`,alt:`The ${m.pictured} of ${Yn(m.id)}`,load:b=>YC(m,b)})}),x("td",{children:[x(Uo,{state:m.state}),m.state==="running"&&x(Ji,{share:m.progress?.fraction??0,label:`Progress: ${Zt(m.progress?.phase??"running")}`})]}),x("td",{children:S.text!==""&&x(Gn,{tone:S.tone,children:S.text})}),x("td",{class:"numeric",children:m.surface_distance?bi(m.surface_distance.mean_mm):""}),x("td",{children:x(Yy,{id:m.id,state:m.state})}),x("td",{children:m.method}),x("td",{children:ms(m.created_at,l)}),x("td",{children:m.started_at?Di((m.finished_at?Date.parse(m.finished_at):l)-Date.parse(m.started_at)):""}),x("td",{children:m.state==="queued"?x(qa,{class:"priority",type:"number",min:-100,max:100,value:String(m.priority),"aria-label":`Priority of job ${Yn(m.id)}, −100 to 100, higher first`,take:b=>{f(m.id,Number(b))}}):m.priority}),x("td",{children:qn(m.state)?x("button",{"aria-label":`Retry job ${Yn(m.id)}`,onClick:()=>h("retry",m.id),children:"Retry"}):x("button",{"aria-label":`Cancel job ${Yn(m.id)}`,disabled:m.cancel_requested,onClick:()=>h("cancel",m.id),children:"Cancel"})})]},m.id)}),g>0&&x("tr",{"aria-hidden":"true",style:{height:`${g}px`}})]})]})})}var JC=6e4,Qh=n=>{let{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,study_id:d,external_ref:y,cancel_requested:v,labels:g}=n,_=d?"target":"source",m=(n[_]?.n_faces??1/0)<=JC?_:null;return{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,study_id:d,external_ref:y,cancel_requested:v,labels:g,pictured:m}},[jy,jC]=[100,500],[ZC,om]=[300,2e3],am=20;function Zy({query:n}){let e=Object.fromEntries(Ic.map(p=>[p,n.get(p)??""])),t=JSON.stringify(e),[i,s]=pe([]),[r,o]=pe(""),[a,l]=pe(null),[c,u]=pe(!0),[h,f]=pe([]),[d,y]=pe(!1),v=p=>l(jt(p)),g=Xt(new Map);g.current=ai(()=>new Map(i.map(p=>[p.id,p])),[i]);let _=Xt(null),[m,S]=Bo("pictures","yes");sn(p=>{s([]),o(""),y(!1);let w=new Set,L=async(K,q)=>{let le=new Set;w.add(le);try{let fe=await K();p.aborted||q(fe,le)}finally{w.delete(le)}},P=(K,q,le)=>L(()=>Mt(`v1/jobs${vi({...e,page_size:K,page_token:q})}`,p),(fe,ge)=>{le(fe,fe.jobs.map(Qh),ge),G(fe.jobs.map(({id:xe})=>xe).filter(xe=>ge.has(xe)))}),N=()=>P(jy,"",(K,q)=>{s(le=>{let fe=new Map(le.map(ge=>[ge.id,ge]));return q.map(ge=>uo(fe.get(ge.id),ge))}),o(K.next_page_token),l(null)}),I=!1,U=async K=>{if(!I){I=!0;try{await P(jC,K,(q,le)=>{s(fe=>[...fe,...le]),o(q.next_page_token),l(null)})}catch(q){p.aborted||v(q)}finally{I=!1}}},D=async()=>{let K=new Set;return e.order==="asc"||await P(jy,"",(q,le,fe)=>{K=new Set(le.map(ge=>ge.id)),s(ge=>{let xe=new Map(ge.map(Ue=>[Ue.id,Ue]));return[...le.map(Ue=>fe.has(Ue.id)&&xe.get(Ue.id)||uo(xe.get(Ue.id),Ue)),...ge.filter(Ue=>!K.has(Ue.id))]})}),K},V=K=>e.state===""||e.state.split(",").includes(K.state),Y=async K=>{for(let q=0;q<K.length&&!p.aborted;q+=am){let le=[],fe=ge=>Mt(`v1/jobs/${ge}`,p).then(Qh,xe=>(Ta(xe)||le.push(ge),null));await L(()=>Promise.all(K.slice(q,q+am).map(fe)),(ge,xe)=>{let Ue=new Map(ge.flatMap(Je=>Je===null||xe.has(Je.id)?[]:[[Je.id,Je]]));s(Je=>Je.map(Ge=>uo(Ge,Ue.get(Ge.id)??Ge)).filter(V))}),G(le,om)}},W=new Set,ae=0,G=(K,q=ZC)=>{K.forEach(le=>W.add(le)),W.size>0&&ae===0&&!p.aborted&&(ae=window.setTimeout(()=>{te()},q))},j=!1,te=async()=>{ae=0;let K=[...W];W.clear();let q=K.filter(fe=>g.current.has(fe)),le=q.length>am;if(le&&j)return G(K,om);j||=le;try{let fe=le||q.length<K.length?await D():new Set;await Y(q.filter(ge=>!fe.has(ge)))}catch(fe){Ta(fe)||G(K,om)}finally{le&&(j=!1)}};_.current={more:U,renew:Y};let ue=N().catch(K=>{p.aborted||v(K)});Gy(async()=>{await ue;try{await N(),y(!0)}catch(K){if(!Ta(K))throw K;v(K)}},K=>{let q=K.map(({job_id:le})=>le);for(let le of w)q.forEach(fe=>le.add(fe));G(q)},u,p),(async()=>{for(;!p.aborted;){await Wn(2e3,p);let K=[...g.current.values()].filter(q=>q.state==="running").slice(0,16);K.length>0&&!document.hidden&&await Y(K.map(q=>q.id))}})()},[t]),mt(()=>{Mt("v1/methods").then(({methods:p})=>f(p.map(({name:w})=>w)),()=>{})},[]);let b=(p,w)=>ji("jobs",{...e,[p]:w},!0),T=()=>{let{order:p,...w}=e,L=Object.values(w).some(P=>P!=="");confirm(L?"Cancel all queued and running jobs that these filters select?":"Cancel all queued and running jobs?")&&$n("POST",`v1/jobs/cancel${vi({...w,all:L?void 0:"true"})}`).catch(v)},M=Ic.some(p=>e[p]!=="");return x("div",{class:"jobs",children:[x("h1",{children:["Jobs ",!c&&x(Gn,{tone:"bad",children:"connection lost, trying again"})]}),x("form",{class:"tools",role:"search","aria-label":"Filters",onSubmit:p=>p.preventDefault(),children:[x("label",{children:["State"," ",x("select",{value:e.state,onChange:p=>b("state",p.currentTarget.value),children:[x("option",{value:"",children:"any"}),hc.map(p=>x("option",{value:p,children:p}))]})]}),x("label",{children:["Method"," ",x("select",{value:e.method,onChange:p=>b("method",p.currentTarget.value),children:[x("option",{value:"",children:"any"}),h.map(p=>x("option",{value:p,children:p}))]})]}),x("label",{children:["Label ",x(qa,{value:e.label,placeholder:"name:value",take:p=>b("label",p)})]}),x("label",{children:["Reference ",x(qa,{value:e.external_ref,take:p=>b("external_ref",p)})]}),x("label",{children:["Order"," ",x("select",{value:e.order,onChange:p=>b("order",p.currentTarget.value),children:[x("option",{value:"",children:"newest first"}),x("option",{value:"asc",children:"oldest first"})]})]}),M&&x("button",{type:"button",onClick:()=>ji("jobs",{},!0),children:"Clear filters"}),x("button",{type:"button",onClick:T,children:"Cancel these …"}),x(Ti,{label:"Pictures",checked:m==="yes",onChange:p=>S(p.currentTarget.checked?"yes":"no")}),x(O0,{filters:e,isFiltered:M})]}),x(Ht,{text:a}),x(Jy,{rows:i,pictures:m==="yes",hasMore:r!==void 0,more:d&&r?()=>{_.current?.more(r)}:null,renew:p=>{_.current?.renew(p)},failed:v}),i.length===0&&r===void 0&&x("p",{class:"empty",children:[M?"No job fits these filters.":"There is no job yet."," ",x("a",{href:"#/submit",children:"Submit a pair of surfaces"}),", or the two built-in phantoms."]})]})}function Qy({batch:n}){let e=Math.max(1,n.n_jobs),t=hc.flatMap(i=>n.counts[i]?[{state:i,n:n.counts[i]}]:[]);return x(Et,{children:[x("svg",{class:"counts",viewBox:"0 0 100 6",preserveAspectRatio:"none","aria-hidden":"true",children:t.map(({state:i,n:s},r)=>{let o=t.slice(0,r).reduce((a,l)=>a+l.n,0);return x("rect",{class:i,x:100*o/e,width:100*s/e,height:"6"})})}),x("span",{class:"soft",children:t.map(({state:i,n:s})=>`${s.toLocaleString("en")} ${i}`).join(", ")})]})}function ev(){let[n,e]=pe([]),[t,i]=pe(),[s,r]=pe(null),[o,a]=pe(!1),l=Ui(),c=async(u,h)=>{try{let f=await Mt(`v1/batches${vi({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.batches:[...d,...f.batches]),i(f.next_page_token),a(!0)}catch(f){h?.aborted||r(jt(f))}};return sn(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Wn(5e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),x("div",{children:[x("h1",{children:"Batches"}),x(Ht,{text:s}),o&&n.length===0&&x("p",{class:"empty",children:["There is no batch yet. ",x("code",{children:"POST /v1/batches"})," submits one template against many subjects at once; ",x("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Batches",children:x("table",{children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Batch"}),x("th",{scope:"col",class:"numeric",children:"Jobs"}),x("th",{scope:"col",children:"States"}),x("th",{scope:"col",children:"Labels"}),x("th",{scope:"col",children:"Age"})]})}),x("tbody",{children:n.map(u=>x("tr",{children:[x("td",{children:x("a",{href:`#/batches/${u.id}`,children:u.external_ref??`…${Yn(u.id)}`})}),x("td",{class:"numeric",children:Re(u.n_jobs)}),x("td",{children:x(Qy,{batch:u})}),x("td",{children:Object.entries(u.labels).map(([h,f])=>`${h}:${f}`).join(", ")}),x("td",{children:ms(u.created_at,l)})]},u.id))})]})}),t!==void 0&&x("button",{onClick:()=>{c(t)},children:"More"})]})}var ef=[{name:"Mean distance, mm",of:n=>n.surface_distance?.mean_mm},{name:"95 % within, mm",of:n=>n.surface_distance?.p95_mm},{name:"Largest distance, mm",of:n=>n.surface_distance?.max_mm}];function Ky(n){return qn(n.state)?n.state!=="succeeded"?2e9:(n.reliable===!1?1e9:0)+(n.surface_distance?.p95_mm??0):-1}function tv({id:n}){let[e,t]=pe(null),[i,s]=pe([]),[r,o]=pe(null),[a,l]=pe(0);if(sn(v=>{(async()=>{try{let g="";for(;!v.aborted;){let _=await Mt(`v1/batches/${n}${g}`,v);t(_);let m=[],S="";for(;S!==void 0;){let b=await Mt(`v1/batches/${n}/jobs${vi({page_size:500,page_token:S})}`,v);m.push(...b.jobs.map(Qh)),S=b.next_page_token}if(s(m),_.finished)return;g="?wait=20",await Wn(500,v)}}catch(g){v.aborted||o(jt(g))}})()},[n]),e===null)return r===null?x("p",{class:"loading",children:"Loading the batch …"}):x(Ht,{text:r});let c=ef[a-1],u=[...i].sort((v,g)=>c?(c.of(g)??-1)-(c.of(v)??-1):Ky(g)-Ky(v)),h=i.filter(v=>v.state==="succeeded"),f=h.filter(v=>v.reliable===!1).length,d=i.filter(v=>qn(v.state)&&v.state!=="succeeded").length,y=d+f>0?"bad":e.finished?"good":"wait";return x("article",{children:[x("h1",{class:"sub",children:["Batch ",e.external_ref??x("code",{children:n})]}),x("section",{class:`verdict ${y}`,"aria-label":"Verdict",children:[x("span",{class:"mark","aria-hidden":"true",children:y==="good"?"✓":y==="bad"?"✕":"…"}),x("div",{children:[x("p",{class:"title",children:d+f>0?`${d+f} of ${Re(e.n_jobs)} need a look`:e.finished?"All reliable, or not checked":"Running"}),x("p",{children:[f," not reliable, ",d," without a result, ",h.length-f," others succeeded."]}),x(Qy,{batch:e})]}),x("div",{class:"actions",children:!e.finished&&x("button",{onClick:()=>$n("POST",`v1/batches/${n}/cancel`).catch(v=>o(jt(v))),children:"Cancel the rest"})})]}),x(Ht,{text:r}),x("div",{class:"columns three",children:ef.map(({name:v,of:g})=>x(KC,{name:v,values:h.flatMap(_=>g(_)??[])},v))}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:x("table",{children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Subject"}),x("th",{scope:"col",children:"State"}),x("th",{scope:"col","aria-sort":a===0?"descending":void 0,children:x("button",{class:"plain",onClick:()=>l(0),children:"Verdict, worst first"})}),ef.map(({name:v},g)=>x("th",{scope:"col",class:"numeric","aria-sort":a===g+1?"descending":void 0,children:x("button",{class:"plain",onClick:()=>l(g+1),children:v})},v)),x("th",{scope:"col",children:"Ran for"})]})}),x("tbody",{children:u.slice(0,500).map(v=>{let g=mc(v);return x("tr",{children:[x("td",{children:x("a",{href:`#/jobs/${v.id}`,children:v.external_ref??`…${Yn(v.id)}`})}),x("td",{children:x(Uo,{state:v.state})}),x("td",{children:g.text!==""&&x(Gn,{tone:g.tone,children:g.text})}),ef.map(({name:_,of:m})=>x("td",{class:"numeric",children:bi(m(v))},_)),x("td",{children:v.started_at&&v.finished_at?Di(Date.parse(v.finished_at)-Date.parse(v.started_at)):""})]},v.id)})})]})}),u.length>500&&x("p",{children:["The first 500 of ",Re(u.length),". ",x("a",{href:`#/jobs?batch=${n}`,children:"All of them"})]})]})}var tf=16;function KC({name:n,values:e}){if(e.length===0)return null;let t=Math.max(...e)*1.0001||1,i=Array.from({length:tf},()=>0);for(let o of e)i[Math.min(tf-1,Math.floor(tf*o/t))]++;let s=i.map((o,a)=>(a+.5)*t/tf),r=[...e].sort((o,a)=>o-a)[Math.floor(e.length/2)];return x("section",{class:"card",children:[x("h2",{children:n}),x(ko,{title:`${n}: ${e.length} matches, median ${r.toPrecision(3)}`,x:s,series:[{label:"matches",color:"#2f7ebc",values:i}],height:170,xLabel:n,yLabel:"matches",bars:!0,marks:[{at:r,text:`median ${r.toPrecision(3)}`}]})]})}var QC=240,lm=64,eR=45,nv=250,cm=56;function tR(n){n.computeBoundingBox();let{min:e,max:t}=n.boundingBox,i=Math.max(t.x-e.x,t.y-e.y,t.z-e.z,1e-9)/cm,s=n.getAttribute("position"),r=new Map,o=new Uint32Array(s.count);for(let c=0;c<s.count;c++){let[u,h,f]=[(s.getX(c)-e.x)/i,(s.getY(c)-e.y)/i,(s.getZ(c)-e.z)/i].map(Math.floor),d=(u*(cm+1)+h)*(cm+1)+f,y=r.get(d);y===void 0&&r.set(d,c),o[c]=y??c}let a=n.getIndex(),l=[];for(let c=0;c<a.count;c+=3){let[u,h,f]=[o[a.getX(c)],o[a.getX(c+1)],o[a.getX(c+2)]];u!==h&&h!==f&&u!==f&&l.push(u,h,f)}return new Ft(Uint32Array.from(l),1)}var nf=class{constructor(e,t,i){this.canvas=e;this.pair=t;this.look=i,this.renderer=new ws({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.renderer.autoClear=!1;let s=g=>{let _=new Ys(g,ti,1);return _.needsUpdate=!0,_};this.maps={viridis:s(tr("viridis")),cividis:s(tr("cividis")),outlier:s(Dy())};let{frame:r}=t,o=t.target.getAttribute("position").array;t.target.setAttribute("place",$p(r,o,()=>!0)),t.source.setAttribute("place",$p(r,t.images,g=>t.nearest[g]>=0)),this.indices={source:{whole:t.source.getIndex()},target:{whole:t.target.getIndex()}},this.meshes={source:this.surface(t.source),target:this.surface(t.target)};let a=Math.max(1e-6,r.high.x-r.low.x),l=new vr(a*.009,16,12);this.marks={source:this.marksOf(l),target:this.marksOf(l)},this.halos={source:this.halo(),target:this.halo()};for(let g of["source","target"])this.groups[g].add(this.meshes[g],this.marks[g],this.halos[g]),this.scene.add(this.groups[g]);this.radius=t.target.boundingSphere.radius;let c=t.source.boundingSphere.center.clone();this.centers={source:c,moved:c.clone().applyMatrix4(t.targetFromSource)};let u=[];t.inlier.forEach((g,_)=>g&&t.nearest[_]>=0&&u.push(_));let h=Math.max(1,Math.floor(u.length/QC));this.lineRows=u.filter((g,_)=>_%h===0);let f=new Qn;f.setAttribute("position",new Ft(new Float32Array(6*this.lineRows.length),3)),this.lines=new xl(f,new ua({transparent:!0,opacity:.55,depthTest:!1})),this.lines.frustumCulled=!1,this.scene.add(this.lines),this.controls=new Pr(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.zoomSpeed=1.4,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.set(i),this.sizes.observe(e);let d=0,y=0,v=g=>{this.waiting=requestAnimationFrame(v),this.controls.update();let _=g-d;d=g,this.isDirty?(g-y<1e3&&y>0&&_>eR&&(this.isSlow=!0),this.detail(!(this.isSlow&&g-y<nv)),y=g,this.draw()):!this.isWhole&&g-y>nv&&(this.detail(!0),this.draw())};v(performance.now())}canvas;pair;renderer;camera=new Ii(-1,1,1,-1,-1e3,1e3);controls;scene=new ns;groups={source:new ys,target:new ys};meshes;marks;halos;lines;lineRows;pose=new gt;centers;maps;sizes=new ResizeObserver(()=>this.resize());look;isSlow=!1;isWhole=!0;indices;waiting=0;isDirty=!0;radius;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.pair.source.dispose(),this.pair.target.dispose()}surface(e){e.setAttribute("value",new Ft(new Float32Array(e.getAttribute("position").count),1));let t=jh(this.maps.viridis),i=new Mn(e,t);return i.matrixAutoUpdate=!1,i}detail(e){if(e!==this.isWhole){this.isWhole=e;for(let t of["source","target"]){let i=this.indices[t];i.coarse??=tR(this.pair[t]),this.pair[t].setIndex(e?i.whole:i.coarse)}}}marksOf(e){let t=new _l(e,new qs({color:16723349,depthTest:!1}),lm);return t.count=0,t.renderOrder=3,t.frustumCulled=!1,t}halo(){let e=new Mn(new vr(1,32,24),new qs({color:16723349,transparent:!0,opacity:.28,depthTest:!1}));return e.visible=!1,e.renderOrder=2,e}view(){let{center:e,axes:t}=this.pair.frame;this.controls.target.copy(e),this.camera.up.copy(t[1]),this.camera.position.copy(e).addScaledVector(t[2],4*this.radius),this.camera.near=-20*this.radius,this.camera.far=40*this.radius,this.camera.zoom=1,this.camera.lookAt(e),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new X().crossVectors(this.camera.up,i).normalize(),r=new Sn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new Sn().setFromAxisAngle(s,t)),i.applyQuaternion(r),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}set(e){let{pair:t}=this;this.look=e;let i=e.coloring==="outlier"?this.maps.outlier:this.maps[e.map];for(let r of["source","target"]){let{uniforms:o}=this.meshes[r].material;if(o.map.value=i,o.byPlace.value=e.coloring==="correspondence",o.grid.value=e.grid&&e.coloring==="correspondence",o.low.value=e.coloring==="displacement"?-e.top:0,o.top.value=e.coloring==="outlier"?1:Math.max(1e-9,e.top),e.coloring!=="correspondence"){let a=r==="source"?t.columns[e.coloring]:t.onTarget[e.coloring],l=this.meshes[r].geometry.getAttribute("value");for(let c=0;c<a.length;c++)l.array[c]=Number.isNaN(a[c])?-1e9:a[c];l.needsUpdate=!0}}let s=this.meshes.source.material;s.transparent=e.overlay&&e.opacity<1,s.depthWrite=!s.transparent,s.uniforms.opacity.value=e.overlay?e.opacity:1,this.meshes.source.renderOrder=1,this.move(),this.resize()}move(){let[e,t,i]=[new X,new Sn,new X];this.pair.targetFromSource.decompose(e,t,i);let s=this.look.pose,r=new Sn().slerp(t,s),o=new X(1,1,1).lerp(i,s),a=this.centers.source.clone().lerp(this.centers.moved,s),l=new gt().compose(new X,r,o);e.copy(a).sub(this.centers.source.clone().applyMatrix4(l)),this.pose.compose(e,r,o),this.meshes.source.matrix.copy(s===1?this.pair.targetFromSource:this.pose),this.pose.copy(this.meshes.source.matrix),this.meshes.source.material.uniforms.pose.value.copy(this.pose),this.redraw()}isStacked(){return this.canvas.clientWidth<1.25*this.canvas.clientHeight}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(e===0||t===0)return;this.renderer.setSize(e,t,!1);let i=this.look.overlay?1:2,s=this.isStacked(),[r,o]=[s?e:e/i,s?t/i:t],{low:a,high:l}=this.pair.frame,[c,u]=[2.2*Math.max(-a.x,l.x),2.3*Math.max(-a.y,l.y,-a.z,l.z)];if(this.look.overlay){let f=this.centers.source.distanceTo(this.centers.moved)*(1-this.look.pose),d=2*f+(f>0?this.radius:0);[c,u]=[c+d,u+d]}let h=Math.max(c/r,u/o);this.camera.left=-e*h/2,this.camera.right=e*h/2,this.camera.top=t*h/2,this.camera.bottom=-t*h/2,this.camera.updateProjectionMatrix(),this.controls.handleResize(),this.redraw()}redraw(){this.isDirty=!0}arrange(){this.camera.updateMatrixWorld();let e=new X().setFromMatrixColumn(this.camera.matrixWorld,0),t=new X().setFromMatrixColumn(this.camera.matrixWorld,1),{source:i,target:s}=this.groups;if(i.position.set(0,0,0),s.position.set(0,0,0),!this.look.overlay){let o=this.isStacked(),a=(o?this.camera.top-this.camera.bottom:this.camera.right-this.camera.left)/this.camera.zoom/4,l=o?t.negate():e;i.position.addScaledVector(l,-a),s.position.addScaledVector(l,a);let c=this.centers.source.clone().applyMatrix4(this.pose);i.position.sub(c).add(this.centers.moved)}let r=new kt().copy(Kp);if(this.look.section!==null){let o=new X().setFromMatrixColumn(this.camera.matrixWorld,2),a=this.pair.frame.center.dot(o)+this.radius*(1-2*this.look.section);r.set(o.x,o.y,o.z,a)}for(let o of["source","target"])this.meshes[o].material.uniforms.section.value.copy(r);if(this.lines.visible=this.look.lines,this.look.lines){let o=this.lines.geometry.getAttribute("position"),[a,l]=[this.pair.source.getAttribute("position"),new X];this.lineRows.forEach((c,u)=>{l.fromBufferAttribute(a,c).applyMatrix4(this.pose).add(i.position),o.setXYZ(2*u,l.x,l.y,l.z),l.fromArray(this.pair.images,3*c).add(s.position),o.setXYZ(2*u+1,l.x,l.y,l.z)}),o.needsUpdate=!0}this.scene.updateMatrixWorld()}draw(){this.isDirty=!1;let{renderer:e,canvas:t}=this,{clientWidth:i,clientHeight:s}=t;if(i===0||s===0)return;this.arrange();let r=getComputedStyle(t);if(e.setClearColor(new st(r.getPropertyValue("--canvas").trim()||"#f4f6f8")),this.lines.material.color.set(r.getPropertyValue("--line").trim()||"#333333"),e.setScissorTest(!1),e.clear(),this.look.overlay){e.render(this.scene,this.camera);return}let{source:o,target:a}=this.groups,l=this.lines.visible,c=this.isStacked();this.lines.visible=!1,e.setScissorTest(!0);for(let[u,h,f]of[[o,a,0],[a,o,1]])u.visible=!0,h.visible=!1,c?e.setScissor(0,f===0?s/2:0,i,s/2):e.setScissor(f*i/2,0,i/2,s),e.render(this.scene,this.camera);e.setScissorTest(!1),o.visible=a.visible=!0,l&&(o.visible=a.visible=!1,this.lines.visible=!0,e.render(this.scene,this.camera),o.visible=a.visible=!0)}pick(e,t){this.detail(!0);let{clientWidth:i,clientHeight:s}=this.canvas;this.arrange();let r=new Kr;r.setFromCamera(new Ke(2*e/i-1,1-2*t/s),this.camera);let o=["source","target"];this.look.overlay||(o=[(this.isStacked()?t>s/2:e>i/2)?"target":"source"]);let a=this.meshes.target.material.uniforms.section.value,l=(m,S)=>S.clone().sub(this.groups[m].position).dot(new X(a.x,a.y,a.z))>a.w,u=o.flatMap(m=>r.intersectObject(this.meshes[m]).map(S=>({side:m,hit:S}))).filter(({side:m,hit:S})=>!l(m,S.point)).sort((m,S)=>m.hit.distance-S.hit.distance)[0];if(u===void 0||!u.hit.face)return null;let{side:h,hit:f}=u,d=this.meshes[h].worldToLocal(f.point.clone()),y=[f.face.a,f.face.b,f.face.c],v=this.meshes[h].geometry.getAttribute("position"),g=m=>d.distanceToSquared(new X().fromBufferAttribute(v,m)),_=y.reduce((m,S)=>g(S)<g(m)?S:m);return this.describe(h,_)}describe(e,t){let{pair:i}=this;if(e==="source")return{side:e,vertex:t,others:[i.nearest[t]],spread_mm:i.columns.spread[t]};let s=[...i.sources.slice(i.starts[t],i.starts[t+1])],r=s.map(o=>i.columns.spread[o]).filter(o=>!Number.isNaN(o));return{side:e,vertex:t,others:s,spread_mm:r.length>0?Math.max(...r):NaN}}mark(e){for(let t of["source","target"])this.marks[t].count=0,this.halos[t].visible=!1;if(e!==null){let{pair:t}=this,i=(a,l)=>new X().fromBufferAttribute(t[a].getAttribute("position"),l).applyMatrix4(a==="source"?this.pose:new gt),s=(a,l)=>{l.slice(0,lm).forEach((c,u)=>this.marks[a].setMatrixAt(u,new gt().makeTranslation(c.x,c.y,c.z))),this.marks[a].count=Math.min(lm,l.length),this.marks[a].instanceMatrix.needsUpdate=!0};s(e.side,[i(e.side,e.vertex)]);let r=e.side==="source"?"target":"source",o;if(e.side==="source"?o=e.others[0]<0?[]:[new X().fromArray(t.images,3*e.vertex)]:o=e.others.map(a=>i("source",a)),s(r,o),o.length>0&&e.spread_mm>0){let a=o.reduce((l,c)=>l.add(c),new X).divideScalar(o.length);this.halos[r].position.copy(a),this.halos[r].scale.setScalar(e.spread_mm),this.halos[r].visible=!0}}this.redraw()}project(e,t){this.arrange();let{geometry:i,matrixWorld:s}=this.meshes[e],r=new X().fromBufferAttribute(i.getAttribute("position"),t).applyMatrix4(s),o=new X().fromBufferAttribute(i.getAttribute("normal"),t).transformDirection(s),a=new X().setFromMatrixColumn(this.camera.matrixWorld,2);r.project(this.camera);let{clientWidth:l,clientHeight:c}=this.canvas;return{x:(r.x+1)/2*l,y:(1-r.y)/2*c,facing:o.dot(a)}}frameTimes(e,t){this.detail(t);let i=this.renderer.getContext(),s=new Uint8Array(4);return Array.from({length:e},()=>{let r=performance.now();return this.turn(.05,.01),this.draw(),i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,s),performance.now()-r})}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var iv=[{name:"correspondence",label:"Correspondence",help:"The target is colored along its length, with a grid; each source vertex has the color and the grid of its corresponding point. Where colors jump or the grid breaks, the match is wrong.",unit:""},{name:"confidence",label:"Confidence",help:"Probability that the corresponding point is right to within one edge of the target.",unit:""},{name:"residual",label:"Residual",help:"Distance of each vertex, moved rigidly, from its corresponding point: how far the rest of the match has to bend the source.",unit:"mm"},{name:"displacement",label:"Displacement",help:"The part of it along the outward normal: the target lies inside of the source where it is negative (dark), outside where it is positive (light).",unit:"mm"},{name:"spread",label:"Spread",help:"Expected error of the corresponding point.",unit:"mm"},{name:"outlier",label:"Outliers",help:"Vertices that do not follow the transform or their neighbors, and why.",unit:""}];function nR({map:n,low:e,high:t,label:i}){let s=Xt(null);return mt(()=>{s.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(tr(n)),ti,1),0,0)},[n]),x("div",{class:"scale",children:[x("span",{children:e}),x("canvas",{ref:s,width:ti,height:1,role:"img","aria-label":i}),x("span",{children:t})]})}function sv({job:n,pair:e}){let t=Xt(null),i=Xt(null),[s,r]=pe(null),[o,a]=pe(null),[l,c]=pe({coloring:"correspondence",map:"viridis",top:1,grid:!0,overlay:!1,pose:1,lines:!1,section:null,opacity:.6}),u=ai(()=>{let m=S=>Hh(e.columns[S].map(Math.abs),.95)||1;return{correspondence:1,confidence:1,outlier:1,residual:m("residual"),displacement:m("displacement"),spread:m("spread")}},[e]),h=m=>c(S=>{let b={...S,...m};return{...b,top:u[b.coloring]}});mt(()=>{let m;try{m=new nf(t.current,e,l)}catch{r("This browser cannot draw in 3D (WebGL 2 is not available). The surfaces can be saved below and opened in another program.");return}return i.current=m,t.current.scene=m,()=>{m.dispose(),i.current=null}},[e]),mt(()=>i.current?.set(l),[l,e]);let f=Hr();mt(()=>i.current?.redraw(),[f]);let d=m=>{if(m.buttons!==0)return;let S=t.current.getBoundingClientRect(),b=i.current?.pick(m.clientX-S.left,m.clientY-S.top)??null;i.current?.mark(b),a(b)},y=()=>{i.current?.mark(null),a(null)},v=m=>{let b={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[m.key];if(b)i.current?.turn(...b);else if(m.key==="+"||m.key==="=")i.current?.zoom(1.2);else if(m.key==="-")i.current?.zoom(1/1.2);else if(m.key==="Home")i.current?.view();else return;m.preventDefault()},g=iv.find(({name:m})=>m===l.coloring),_=e.columns;return x("section",{class:"viewer","aria-label":"The match in 3D",children:[x("div",{class:"tools",children:[x("label",{children:["Color"," ",x("select",{value:l.coloring,onChange:m=>h({coloring:m.currentTarget.value}),children:iv.map(({name:m,label:S})=>x("option",{value:m,children:S}))})]}),x("label",{children:["Map"," ",x("select",{value:l.map,onChange:m=>h({map:m.currentTarget.value}),children:[x("option",{value:"viridis",children:"viridis"}),x("option",{value:"cividis",children:"cividis"})]})]}),x("div",{class:"choice",role:"group","aria-label":"Arrangement",children:[x("button",{"aria-pressed":!l.overlay,onClick:()=>h({overlay:!1}),children:"Side by side"}),x("button",{"aria-pressed":l.overlay,onClick:()=>h({overlay:!0}),children:"Overlaid"})]}),x("label",{class:"slider",children:["Pose: original"," ",x("input",{type:"range",min:0,max:1,step:.01,value:l.pose,"aria-label":"Pose, from original to aligned",onInput:m=>h({pose:Number(m.currentTarget.value)})})," aligned"]}),l.overlay&&x("label",{class:"slider",children:["Source"," ",x("input",{type:"range",min:.15,max:1,step:.05,value:l.opacity,"aria-label":"Opacity of the source",onInput:m=>h({opacity:Number(m.currentTarget.value)})})]}),l.coloring==="correspondence"&&x(Ti,{label:"Grid",checked:l.grid,onChange:m=>h({grid:m.currentTarget.checked})}),x(Ti,{label:"Inlier lines",checked:l.lines,onChange:m=>h({lines:m.currentTarget.checked})}),x(Ti,{label:"Section",checked:l.section!==null,onChange:m=>h({section:m.currentTarget.checked?.4:null})}),l.section!==null&&x("input",{type:"range",min:.02,max:.98,step:.01,value:l.section,"aria-label":"Depth of the section",onInput:m=>h({section:Number(m.currentTarget.value)})}),x("span",{class:"group",children:[x("button",{onClick:()=>i.current?.view(),children:"Reset view"}),x("button",{onClick:async()=>{let m=await i.current?.picture();m&&ka(m,`match-${n.id}.png`)},children:"Save picture"})]})]}),s!==null&&x("p",{class:"failure",children:s}),x("div",{class:"stage",children:[!l.overlay&&x(Et,{children:[x("span",{class:"caption first",children:["Source",l.pose===1?", aligned":l.pose===0?", original pose":""]}),x("span",{class:"caption second",children:"Target"})]}),x("canvas",{ref:t,id:"view",tabIndex:0,role:"img","aria-label":"Source and target surface. Arrow keys turn, plus and minus zoom, Home resets the view.",onPointerMove:d,onPointerLeave:y,onKeyDown:v}),x("output",{class:"readout","aria-live":"off",children:o===null?x("span",{class:"hint",children:"Point at a vertex to see its correspondent. Drag to turn, scroll to zoom, right button to move."}):o.side==="source"?x(Et,{children:[x("b",{children:["source vertex ",o.vertex]})," → ",o.others[0]<0?"no counterpart":`target vertex ${o.others[0]}`," · confidence ",Re(_.confidence[o.vertex],2)," · spread"," ",bi(_.spread[o.vertex])," · residual ",bi(_.residual[o.vertex])," · ",er[Math.floor(_.outlier[o.vertex]*er.length)]?.name]}):x(Et,{children:[x("b",{children:["target vertex ",o.vertex]})," ← ",o.others.length===0?"no source vertex has it as its nearest":`${o.others.length} source ${o.others.length===1?"vertex":"vertices"}: ${o.others.slice(0,6).join(", ")}${o.others.length>6?" …":""}`,o.spread_mm>0&&` · spread ${bi(o.spread_mm)}`]})})]}),x("div",{class:"legend",children:[l.coloring==="outlier"?x("ul",{class:"categories",children:er.map(({name:m,color:S},b)=>{let T=_.outlier.reduce((M,p)=>M+(Math.floor(p*er.length)===b?1:0),0);return x("li",{children:[x("svg",{width:"12",height:"12","aria-hidden":"true",children:x("rect",{width:"12",height:"12",fill:Oy(S)})})," ",m,": ",T.toLocaleString("en")]})})}):x(nR,{map:l.map,low:l.coloring==="correspondence"?"one end of the target":l.coloring==="displacement"?`≤ −${Re(l.top,2)} mm`:`0 ${g.unit}`,high:l.coloring==="correspondence"?"the other end":`${l.coloring==="confidence"?"":"≥ "}${Re(l.top,2)} ${g.unit}`,label:`Scale of ${Zt(l.coloring)}`}),x("p",{children:[g.help," Gray: no counterpart."]})]})]})}var iR=[["Correspondences, CSV","correspondences?format=csv","correspondences.csv"],["Aligned source, PLY","aligned?format=ply","aligned.ply"],["Bent source, PLY","warped?format=ply","warped.ply"],["Bent source, GIFTI","warped?format=gifti","warped.surf.gii"],["Bent source, VTP","warped?format=vtp","warped.vtp"],["Target surface, PLY","surfaces/target?format=ply","target.ply"],["Both surfaces in color, glTF","correspondences?format=glb","match.glb"],["Transform, ITK","transform?format=tfm","transform.tfm"],["Transform, FreeSurfer","transform?format=lta","transform.lta"],["Result, JSON","result","result.json"],["Report, HTML","report?format=html","report.html"]];function rv({job:n,failed:e}){return x("div",{class:"saves",children:iR.map(([t,i,s])=>x("button",{onClick:()=>dc(`v1/jobs/${n.id}/${i}`,s).catch(e),children:t}))})}function av({id:n}){let[e,t]=pe(null),[i,s]=pe([]),[r,o]=pe(null),[a,l]=pe(null),[c,u]=pe(!0),[h,f]=pe(null),d=T=>f(jt(T)),y=Ui();sn(T=>{t(null),s([]),o(null),l(null),f(null),Gi(()=>Mt(`v1/jobs/${n}`,T),T).then(L=>!T.aborted&&t(P=>P??L),L=>!T.aborted&&d(L));let M=[],p=0,w=()=>{p=0;let L=M;M=[],T.aborted||s(P=>[...P,...L])};Vy(n,{job:L=>t(P=>uo(P,{...L,queue_position:L.queue_position??(L.state==="queued"?P?.queue_position:void 0)})),trace:L=>{M.push(...L),p===0&&(p=window.setTimeout(w,60))},progress:L=>t(P=>P===null?P:{...P,progress:L}),connected:u,failed:d},T)},[n]);let v=e?.state==="succeeded";sn(T=>{!v||e===null||Hy(e,T).then(M=>{T.aborted||(l(M.result),o(M.pair))},M=>!T.aborted&&d(M))},[n,v]);let g=e!==null&&!qn(e.state),_=ai(()=>x(oR,{points:i,isLive:g}),[i,g]);if(e===null)return h===null?x("p",{class:"loading",children:"Loading the job …"}):x(Ht,{text:h});let m=og(e),S=T=>{f(null),$n("POST",`v1/jobs/${n}/${T}`).then(M=>T==="retry"?ji(`jobs/${M.id}`):t(p=>p?.id===M.id?uo(p,M):p),d)},b=e.started_at?Di((e.finished_at?Date.parse(e.finished_at):y)-Date.parse(e.started_at)):null;return x("article",{class:"job",children:[x("h1",{class:"sub",children:["Job ",x("code",{children:n})]}),x("section",{class:`verdict ${m.tone}`,"aria-label":"Verdict",children:[x("span",{class:"mark","aria-hidden":"true",children:m.mark}),x("div",{children:[x("p",{class:"title",id:"verdict",children:m.title}),m.lines.map(T=>x("p",{children:T})),x("p",{class:"next",children:[x("b",{children:"Next:"})," ",m.next]})]}),x("div",{class:"actions",children:[!qn(e.state)&&x("button",{disabled:e.cancel_requested,onClick:()=>S("cancel"),children:"Cancel"}),qn(e.state)&&x("button",{onClick:()=>S("retry"),children:"Retry"})]})]}),x(Ht,{text:h}),!qn(e.state)&&x("p",{class:"live",role:"status",children:[x(Ji,{share:e.progress?.fraction??0,label:"Progress"})," ",Ao(e.progress?.fraction??0)," · ",e.progress?.message??Zt(e.state)," ",b!==null&&`· ${b}`,!c&&x(Gn,{tone:"bad",children:"connection lost, trying again"})]}),r!==null&&x(sv,{job:e,pair:r}),v&&r===null&&h===null&&x("p",{class:"loading big",children:"Loading the surfaces …"}),x("div",{class:"columns",children:[a!==null&&x(sR,{result:a}),_,x("section",{class:"card",children:[x("h2",{children:"The job"}),x(Jn,{rows:[["State",x(Uo,{state:e.state})],["Method",`${e.method} ${e.method_version}`],["Source",`${Re(e.source.n_vertices)} vertices, ${e.source.report.format}`],["Target",`${Re(e.target.n_vertices)} vertices, ${e.target.report.format}`],["Priority",Re(e.priority)],["Attempt",`${e.attempt} of ${e.max_attempts}`],["Created",new Date(e.created_at).toLocaleString()],["Ran for",b??"–"],["Result from",e.cached?"an earlier, equal job":"this job"],...e.batch_id?[["Batch",x("a",{href:`#/batches/${e.batch_id}`,children:e.batch_id.slice(-8)})]]:[],...e.retry_of?[["Retry of",x("a",{href:`#/jobs/${e.retry_of}`,children:e.retry_of.slice(-8)})]]:[],...e.external_ref?[["Reference",e.external_ref]]:[],...Object.entries(e.labels).map(([T,M])=>[`Label ${T}`,M])]})]}),a!==null&&x(aR,{result:a}),v&&x("section",{class:"card",children:[x("h2",{children:"Save"}),x(rv,{job:e,failed:d})]}),x(lR,{job:e}),x("section",{class:"card",children:[x("h2",{children:"Parameters and provenance"}),x(cR,{job:e}),a!==null&&x(Jn,{rows:[["Program",`${a.provenance.version}, commit ${a.provenance.commit}`],["Seed",Re(a.provenance.seed)],["Source file",x("code",{class:"hash",children:e.source.hash})],["Target file",x("code",{class:"hash",children:e.target.hash})]]})]})]})]})}function sR({result:n}){let{surface_distance:e,topology:t,deformation:i,support:s,reliability:r}=n,o=[["Surface distance, mean",bi(e.mean_mm)],["Surface distance, 95 % within",bi(e.p95_mm)],["Surface distance, largest",bi(e.max_mm)],["Neighbors that stay neighbors",Ao(t.consistency)],["Target vertices reached",Ao(t.coverage)],["Inliers of the transform",`${Re(s.inliers)} (${Ao(s.ratio)})`],["Rotation",`${n.transform.rotation_angle_deg.toFixed(1)}°`]];return i&&o.push(["Folded triangles",`${Re(i.folded_triangles)} (${Ao(i.folded_area_share)} of the area)`],["Area, target over source (5th to 95th percentile)",`${Re(i.area_ratio)} (${Re(i.area_ratio_p05)} to ${Re(i.area_ratio_p95)})`],["Volume, target over source",Re(i.volume_ratio)]),r&&(o.push(["Misfit (about 1.0 for copies, 1.2 for two subjects)",Re(r.misfit)],["Misfit of the next best pose",Re(r.runner_up_misfit)],["Misfit of a mirrored source",Re(r.other_handedness_misfit)],["Curvature agreement",Re(r.curvature_agreement)],["Agreement of directions",Re(r.normal_agreement)]),r.distortion!==void 0&&o.push(["Distortion (0 if angles are kept, about 0.2 for two subjects)",Re(r.distortion)])),x("section",{class:"card",children:[x("h2",{children:"How good it is"}),x(Jn,{rows:o})]})}var ov=4e3;function rR(n){if(n.length<=ov)return n;let e=Math.ceil(2*n.length/ov),t=[];for(let i=0;i<n.length;i+=e){let s=Math.min(n.length,i+e),[r,o]=[i,i];for(let a=i+1;a<s;a++){let l=n[a].energy;l!==void 0&&(l>=(n[r].energy??1/0)||(r=a),l<=(n[o].energy??-1/0)||(o=a))}for(let a=i;a<s;a++){let l=n[a];(a===r||a===o||a===n.length-1||l.support!==void 0||l.round!==n[a-1]?.round)&&t.push(l)}}return t}function oR({points:n,isLive:e}){let[t,i]=pe(!1),[s,r]=pe(!1),[o,a]=pe("all"),[l,c]=pe(null),u=ai(()=>n.filter(Ba),[n]),h=ai(()=>n.filter(M=>!Ba(M)&&(M.energy!==void 0||M.support!==void 0)),[n]),f=(l??(u.length>0?"field":"labels"))==="field"?u:h,d=ai(()=>[...new Set(f.map(M=>M.round))],[f]),y=d.map(String).includes(o),v=ai(()=>f.filter(M=>!y||String(M.round)===o),[f,y,o]),g=ai(()=>rR(v),[v]),_=M=>g.map(p=>{let w=p[M];return w===void 0||t&&M!=="support"&&w<=0?null:w}),m=M=>g.some(p=>p[M]!==void 0),S=g.flatMap((M,p)=>p===0||g[p-1].round!==M.round?[{at:M.seq,text:`round ${M.round}`}]:[]),b=v.at(-1),T=[{label:"energy",color:"#0072b2",values:_("energy"),width:2.5},...s?[{label:f===u?"misfit":"unary",color:"#d55e00",values:_("energy_unary"),dash:[6,3]},{label:f===u?"deformation":"pairwise",color:"#009e73",values:_("energy_pairwise"),dash:[2,3]}]:[],...m("lower_bound")?[{label:"lower bound",color:"#8c6d1f",values:_("lower_bound"),dash:[10,4]}]:[],...m("temperature")?[{label:"temperature",color:"#cc79a7",values:_("temperature"),scale:"right"}]:[],...m("support")&&!m("temperature")?[{label:"support (inliers)",color:"#b0607f",values:_("support"),scale:"right",points:!0}]:[]];return x("section",{class:"card wide",id:"trace","data-points":n.length,"data-last":n.at(-1)?.seq??0,children:[x("h2",{children:["Energy ",e&&x(Gn,{tone:"wait",children:"live"})]}),x("div",{class:"tools",children:[x(Ti,{label:"Logarithmic",checked:t,onChange:M=>i(M.currentTarget.checked)}),x(Ti,{label:"Its parts",checked:s,onChange:M=>r(M.currentTarget.checked)}),u.length>0&&h.length>0&&x("label",{children:["Of"," ",x("select",{value:f===u?"field":"labels",onChange:M=>c(M.currentTarget.value==="field"?"field":"labels"),children:[x("option",{value:"field",children:"the displacement field"}),x("option",{value:"labels",children:"the labels"})]})]}),d.length>1&&x("label",{children:["Round"," ",x("select",{value:y?o:"all",onChange:M=>a(M.currentTarget.value),children:[x("option",{value:"all",children:"all"}),d.map(M=>x("option",{value:String(M),children:M}))]})]}),b&&x("span",{children:[n.length," points · latest ",Re(b.energy??null)," in ",Zt(b.phase),", round ",b.round,", iteration ",b.iteration]})]}),g.length===0?x("p",{class:"hint",children:e?"The first point comes with the first iteration.":"This method minimizes no energy, or its trace has been removed."}):x(ko,{title:`Energy over ${n.length} points, the last one ${Re(b?.energy??null)}`,x:g.map(M=>M.seq),series:T,log:t,height:260,xLabel:"point of the trace",yLabel:"energy, lower is better",rightLabel:m("temperature")?"temperature":"inliers",marks:S})]})}function aR({result:n}){let{total:e=1,...t}=n.timings_ms,i=Object.entries(t).sort(([,s],[,r])=>r-s);return x("section",{class:"card",children:[x("h2",{children:["Time: ",Di(e)]}),x(Jn,{rows:i.map(([s,r])=>[Zt(s),x(Et,{children:[x(Ji,{share:r/e,label:`Share of ${Zt(s)}`})," ",Di(r)]})])})]})}function lR({job:n}){let{source:e,target:t}=n,i=(s,r)=>x("tr",{children:[x("th",{scope:"row",children:s}),x("td",{children:r(e)}),x("td",{children:r(t)})]});return x("section",{class:"card",children:[x("h2",{children:"Surfaces"}),x("table",{class:"plain",children:[x("thead",{children:x("tr",{children:[x("td",{}),x("th",{scope:"col",children:"Source"}),x("th",{scope:"col",children:"Target"})]})}),x("tbody",{children:[i("Format",s=>s.report.format),i("Vertices",s=>Re(s.n_vertices)),i("Faces",s=>Re(s.n_faces)),i("Genus",s=>String(s.report.topology.genus??"open")),i("Pieces",s=>Re(s.report.topology.n_components)),i("Boundary edges",s=>Re(s.report.topology.n_boundary_edges)),i("Area",s=>`${Re(s.report.topology.area_mm2)} mm²`),i("Volume",s=>s.report.topology.volume_mm3===null?"–":`${Re(s.report.topology.volume_mm3)} mm³`),i("Repairs",s=>s.report.repairs.length===0?"none":String(s.report.repairs.length))]})]})]})}function cR({job:n}){let[e,t]=pe(null);sn(o=>{Gi(()=>Mt(`v1/methods/${n.method}`,o),o).then(a=>!o.aborted&&t(a.defaults),()=>{})},[n.method]);let i=um(n.parameters),s=new Map(e?um(e):[]),r=e===null?[]:i.filter(([o,a])=>o!=="seed"&&s.get(o)!==a);return x(Et,{children:[x("p",{children:e===null?"":r.length===0?`All as the method ${n.method} sets them.`:`Different from the method ${n.method}:`}),r.length>0&&x(Jn,{rows:r.map(([o,a])=>[o,x("code",{children:a})])}),x("details",{children:[x("summary",{children:["All ",i.length," parameters"]}),x(Jn,{rows:i.map(([o,a])=>[o,x("code",{children:a})])})]})]})}function um(n,e=""){return n===null||typeof n!="object"||Array.isArray(n)?[[e,JSON.stringify(n)]]:Object.entries(n).flatMap(([t,i])=>um(i,e===""?t:`${e}.${t}`))}function uR(n){let e=new Map;for(let t of n.split(`
`)){let i=/^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)$/.exec(t);if(!i||t.startsWith("#"))continue;let s=Object.fromEntries([...(i[2]??"").matchAll(/(\w+)="((?:[^"\\]|\\.)*)"/g)].map(([,o,a])=>[o,a])),r=e.get(i[1])??[];r.push({labels:s,value:Number(i[3])}),e.set(i[1],r)}return e}var lv=500;function cv(){let[n,e]=pe(null),[t,i]=pe([]),[s,r]=pe([]),[o,a]=pe([]),[l,c]=pe(null),[u,h]=pe(null),f=Ui();if(sn(p=>{(async()=>{for(let w=0;!p.aborted;w++){try{let L=uR(await(await Vn("metrics",{signal:p})).text()),P=N=>L.get("homolog_jobs")?.find(({labels:I})=>I.state===N)?.value??0;e(L),i(N=>[...N.slice(-299),{at:Date.now(),queued:P("queued"),running:P("running")}]),r((await Mt("v1/jobs?state=running&page_size=100",p)).jobs),Mt("readyz",p).then(({dependencies:N})=>c(N),N=>c(N instanceof hi?N.problem.dependencies??{}:null)),w%10===0&&a(await hR(p)),h(null)}catch(L){p.aborted||h(jt(L))}await Wn(2e3,p)}})()},[]),n===null)return u===null?x("p",{class:"loading",children:"Loading …"}):x(Ht,{text:u});let d=p=>n.get(p)?.[0]?.value??0,y=(p,w)=>(n.get(p)??[]).map(({labels:L,value:P})=>[L[w]??Object.values(L).join(" "),P]).filter(([,L])=>L>0),v=t.at(-1),g=d("homolog_queue_oldest_age_seconds"),_=d("homolog_job_store_up")===1,m=Object.entries(l??{}).filter(([,p])=>p!=="ok"),S=v.queued>0&&v.running===0&&g>30,b=!_||m.length>0||S?"bad":g>600?"wait":"good",T=new Map;for(let p of s){let w=p.worker??"unnamed worker";T.set(w,[...T.get(w)??[],p])}let M=t[0].at;return x("div",{children:[x("h1",{children:"Operations"}),x("section",{class:`verdict ${b}`,"aria-label":"Verdict",children:[x("span",{class:"mark","aria-hidden":"true",children:b==="good"?"✓":b==="bad"?"✕":"…"}),x("div",{children:[x("p",{class:"title",children:b==="good"?"The queue is well":S?"Nothing runs":b==="wait"?"Jobs wait long":"A dependency fails"}),x("p",{children:[Re(v.queued)," queued, ",Re(v.running)," running; the oldest has waited ",Di(g*1e3),"."]}),x("p",{class:"next",children:[x("b",{children:"Next:"})," ",b==="good"?"nothing to do.":S?"Look whether workers run, and whether a job asks for more memory than there is.":b==="wait"?"Add workers, or lower the priority of what can wait.":`Look at ${m.map(([p,w])=>`${p} (${w})`).join(", ")||"the database"}.`]})]})]}),x(Ht,{text:u}),x("div",{class:"columns",children:[x("section",{class:"card wide",children:[x("h2",{children:"Queue, since this page was opened"}),x(ko,{title:`Queued ${v.queued}, running ${v.running}`,x:t.map(({at:p})=>(p-M)/1e3),series:[{label:"queued",color:"#2f7ebc",values:t.map(({queued:p})=>p),width:2},{label:"running",color:"#d55e00",values:t.map(({running:p})=>p),width:2}],height:220,xLabel:"seconds",yLabel:"jobs"})]}),x("section",{class:"card",children:[x("h2",{children:"Workers and what they run"}),T.size===0&&x("p",{class:"hint",children:"No job is running."}),[...T].map(([p,w])=>x("div",{children:[x("h3",{children:[x("code",{children:p}),": ",w.length," ",w.length===1?"job":"jobs"]}),x("ul",{class:"running",children:w.map(L=>x("li",{children:[x("a",{href:`#/jobs/${L.id}`,children:["…",Yn(L.id)]})," ",L.method,", ",Zt(L.progress?.phase??"starting"),", ",L.started_at?ms(L.started_at,f):""," ",x(Ji,{share:L.progress?.fraction??0,label:`Progress of ${Yn(L.id)}`})]}))})]},p))]}),x("section",{class:"card",children:[x("h2",{children:"Failures by kind"}),o.length===0?x("p",{class:"hint",children:"No job of this tenant has failed."}):x(Jn,{rows:o.map(([p,w,L])=>[p,x(Et,{children:[Re(w),", newest ",x("a",{href:`#/jobs/${L}`,children:["…",Yn(L)]})]})])}),x("p",{class:"soft",children:["Among the last ",lv," jobs of this tenant that failed or were given up."]})]}),x("section",{class:"card",children:[x("h2",{children:"Finished since the service was started"}),x(Jn,{rows:y("homolog_jobs_finished_total","state").map(([p,w])=>[p,Re(w)])}),x(Jn,{rows:y("homolog_problems_total","type").map(([p,w])=>[`Refused: ${Zt(p).replaceAll("-"," ")}`,Re(w)])})]}),x("section",{class:"card",children:[x("h2",{children:"This process"}),x(Jn,{rows:[...Object.entries(l??{}).map(([p,w])=>[Zt(p),x(Gn,{tone:w==="ok"?"good":"bad",children:w})]),["Memory",pc(d("process_resident_memory_bytes"))],["Running since",d("process_start_time_seconds")?new Date(1e3*d("process_start_time_seconds")).toLocaleString():"–"],["Leases of lost workers",Re(d("homolog_leases_expired_total"))],["Jobs given up",Re(d("homolog_jobs_dead_total"))]]})]})]})]})}async function hR(n){let e=await Promise.all(["failed","dead"].map(i=>Mt(`v1/jobs${vi({state:i,page_size:lv})}`,n))),t=new Map;for(let i of e.flatMap(({jobs:s})=>s)){let s=i.error?.title??"Crashed too often",[r,o]=t.get(s)??[0,i.id];t.set(s,[r+1,o>i.id?o:i.id])}return[...t].map(([i,[s,r]])=>[i,s,r]).sort(([,i],[,s])=>s-i)}var fR={queued:"wait",matching:"wait",modelling:"wait",finished:"good",failed:"bad",cancelled:"neutral"},hm=({state:n})=>x(Gn,{tone:fR[n],children:n==="modelling"?"modeling":n}),sf=n=>n==="finished"||n==="failed"||n==="cancelled";function fm({state:n,progress:e}){let{template_round:t,matches_done:i,matches_total:s}=e;return n==="queued"?"waits for a worker":n==="modelling"?"computes the shape model and the statistics":n==="matching"?`${t>0?`makes the template, round ${t}`:"matches the subjects"}: ${Re(i)} of ${Re(s)}`:n}function uv(){let[n,e]=pe([]),[t,i]=pe(),[s,r]=pe(null),[o,a]=pe(!1),l=Ui(),c=async(u,h)=>{try{let f=await Mt(`v1/studies${vi({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.studies:[...d,...f.studies]),i(f.next_page_token),r(null),a(!0)}catch(f){h?.aborted||r(jt(f))}};return sn(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Wn(3e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),x("div",{children:[x("h1",{children:"Studies"}),x(Ht,{text:s}),o&&n.length===0&&x("p",{class:"empty",children:["There is no study yet. ",x("code",{children:"POST /v1/studies"})," or ",x("code",{children:"homolog study"})," begins one; ",x("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Studies",children:x("table",{children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Study"}),x("th",{scope:"col",children:"State"}),x("th",{scope:"col",children:"Progress"}),x("th",{scope:"col",class:"numeric",children:"Subjects"}),x("th",{scope:"col",children:"Method"}),x("th",{scope:"col",children:"Labels"}),x("th",{scope:"col",children:"Age"})]})}),x("tbody",{children:n.map(u=>x("tr",{children:[x("td",{children:x("a",{href:`#/studies/${u.id}`,children:u.external_ref??`…${Yn(u.id)}`})}),x("td",{children:x(hm,{state:u.state})}),x("td",{children:[u.state==="matching"&&x(Ji,{share:u.progress.matches_done/Math.max(1,u.progress.matches_total),label:`Progress of ${u.external_ref??Yn(u.id)}`}),!sf(u.state)&&x("span",{class:"soft",children:fm(u)}),u.error&&x("span",{class:"soft",children:u.error.title})]}),x("td",{class:"numeric",children:Re(u.n_subjects)}),x("td",{children:u.method}),x("td",{children:Object.entries(u.labels).map(([h,f])=>`${h}:${f}`).join(", ")}),x("td",{children:ms(u.created_at,l)})]},u.id))})]})}),t!==void 0&&x("button",{onClick:()=>{c(t)},children:"More"})]})}function hv(n){let e=[[]],[t,i]=["",!1],s=()=>{e.at(-1).push(/^'[=+\-@\t\r\n]/.test(t)?t.slice(1):t),t=""};for(let a=0;a<n.length;a++){let l=n[a];i?l!=='"'?t+=l:n[a+1]==='"'?t+=n[++a]:i=!1:l==='"'?i=!0:l===","?s():l===`
`?(s(),e.push([])):l!=="\r"&&(t+=l)}(t!==""||e.at(-1).length>0)&&s();let[r=[],...o]=e;return o.filter(a=>a.length>0).map(a=>Object.fromEntries(r.map((l,c)=>[l,a[c]??""])))}function dm({map:n,title:e,ticks:t}){let i=Xt(null);return mt(()=>{i.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(tr(n)),ti,1),0,0)},[n]),x("figure",{class:"colorbar",children:[x("figcaption",{children:e}),x("canvas",{ref:i,width:ti,height:1,role:"img","aria-label":`Color bar of ${e}, from ${t[0]} to ${t.at(-1)}`}),x("div",{class:"ticks","aria-hidden":"true",children:t.map(s=>x("span",{children:s},s))})]})}function ho(n){let e=new DataView(n),t=0,i=()=>{let l="";for(;t<e.byteLength;){let c=e.getUint8(t++);if(c===10)break;l+=String.fromCharCode(c)}return l},s=()=>{for(;;){let l=i().trim();if(l!==""||t>=e.byteLength)return l.split(" ")}},r=(l,c)=>{let u={double:8,vtktypeint64:8,float:4,int:4,unsigned_char:1}[c??""];if(u===void 0||t+l*u>e.byteLength)throw new Error("This VTK file cannot be read.");let h=d=>{let y=t+d*u;return c==="double"?e.getFloat64(y):c==="float"?e.getFloat32(y):c==="vtktypeint64"?Number(e.getBigInt64(y)):c==="int"?e.getInt32(y):e.getUint8(y)},f=Float64Array.from({length:l},(d,y)=>h(y));return t+=l*u,f},o=new Qn,a={};for(let l=0;l<4;l++)i();for(;t<e.byteLength;){let[l,c,u]=s();if(l==="POINTS")o.setAttribute("position",new Ft(Float32Array.from(r(3*Number(c),u)),3));else if(l==="POLYGONS"){let h=r(Number(c),s()[1]),f=r(Number(u),s()[1]),d=[];for(let y=0;y+1<h.length;y++)for(let v=h[y]+1;v+1<h[y+1];v++)d.push(f[h[y]],f[v],f[v+1]);o.setIndex(new Ft(Uint32Array.from(d),1))}else if(l==="FIELD")for(let h=0;h<Number(u);h++){let[f,d,y,v]=s();a[f]=Float32Array.from(r(Number(d)*Number(y),v))}}return o.computeVertexNormals(),o.computeBoundingSphere(),{geometry:o,arrays:a}}function pv({geometry:n,coloring:e,positions:t,label:i,id:s,file:r,readout:o}){let a=Xt(null),l=Xt(null),[c,u]=pe(null),[h,f]=pe(null),d=Hr();mt(()=>{try{l.current=new Zh(a.current,n.clone())}catch{u("This browser cannot draw in 3D (WebGL 2 is not available). The maps are in the archive.");return}return a.current.scene=l.current,()=>{l.current?.dispose(),l.current=null}},[n]),mt(()=>{e&&l.current?.color(e)},[n,e]),mt(()=>{t&&l.current?.move(t)},[n,t]),mt(()=>l.current?.redraw(),[d]);let y=g=>{if(g.buttons!==0)return;let _=a.current.getBoundingClientRect();f(l.current?.pick(g.clientX-_.left,g.clientY-_.top)??null)},v=g=>{let m={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[g.key];if(m)l.current?.turn(...m);else if(g.key==="+"||g.key==="=")l.current?.zoom(1.2);else if(g.key==="-")l.current?.zoom(1/1.2);else if(g.key==="Home")l.current?.view();else return;g.preventDefault()};return x(Et,{children:[x(Ht,{text:c}),x("div",{class:"stage half",children:x("canvas",{ref:a,id:s,tabIndex:0,role:"img","aria-label":`${i}. Arrow keys turn, plus and minus zoom, Home resets the view.`,onPointerMove:y,onPointerLeave:()=>f(null),onKeyDown:v})}),x("output",{class:"readout","aria-live":"off",children:h===null?x("span",{class:"hint",children:"Point at a vertex for its values. Drag to turn, scroll to zoom."}):o(h)}),x("div",{class:"tools",children:[x("button",{onClick:()=>l.current?.view(),children:"Reset view"}),x("button",{onClick:async()=>{let g=await l.current?.picture();g&&ka(g,r)},children:"Save picture"})]})]})}var fv={normal_displacement:{title:"normal displacement",unit:"mm"},log_area:{title:"logarithm of area",unit:"ln"},thickness:{title:"thickness",unit:"mm"}},dR=[{name:"effect",title:"effect",kind:"effect"},{name:"hedges_g",title:"Hedges' g",kind:"signed"},{name:"t",title:"t",kind:"signed"},{name:"z",title:"z",kind:"signed"},{name:"p_tfce_fwe",title:"p, corrected (TFCE, family-wise)",kind:"p"},{name:"p_permutation",title:"p, uncorrected (permutations)",kind:"p"},{name:"p",title:"p, uncorrected",kind:"p"},{name:"q_fdr",title:"q (false discovery rate)",kind:"p"}],dv=3,mv=n=>[-1,-.5,0,.5,1].map(e=>e===0?"0":`${e===-1?"≤ ":e===1?"≥ ":""}${e<0?"−":""}${Re(Math.abs(e)*n,2)}`),gv=n=>Hh(n.map(Math.abs),.99)||1e-6;function _v({archive:n,result:e,name:t}){let i=e.found.maps.filter(({measure:I,contrast:U})=>n.has(`maps/${I}.${U}.vtk`)),s=[...new Set(i.map(({contrast:I})=>I))],[r,o]=pe(s[0]??""),[a,l]=pe(i[0]?.measure??""),[c,u]=pe("effect"),[h,f]=pe(!1),[d,y]=pe(null),[v,g]=pe(null),_=`maps/${a}.${r}.vtk`;sn(I=>{n.has(_)&&n.bytes(_).then(U=>{if(I.aborted)return;let{geometry:D,arrays:V}=ho(U);y(Y=>({file:_,geometry:Y?.geometry??D,arrays:V}))},U=>!I.aborted&&g(jt(U)))},[n,_]);let m=d?.arrays,S=dR.filter(({name:I})=>m===void 0||I in m),b=S.find(({name:I})=>I===c)??S[0],T=m?.p_tfce_fwe??m?.q_fdr,{title:M,unit:p}=fv[a]??{title:Zt(a),unit:""},w=ai(()=>{let I=m?.[b.name];if(I===void 0)return null;let U=V=>!h||T===void 0||T[V]<.05;if(b.kind==="p")return{coloring:{values:I.map((Y,W)=>U(W)?-Math.log10(Math.max(Y,10**-dv)):NaN),low:0,high:dv,map:"viridis"},ticks:["1","0.1","0.01","≤ 0.001"],map:"viridis"};let D=gv(I);return{coloring:{values:I.map((V,Y)=>U(Y)?V:NaN),low:-D,high:D,map:"blue_red"},ticks:mv(D),map:"blue_red"}},[m,b.name,h]);if(i.length===0)return x("p",{class:"hint",children:"No effect was asked for, so there are no maps."});let L=i.find(I=>I.measure===a&&I.contrast===r),P=b.kind==="effect"?`effect on ${M}${p==="mm"?", mm":p==="ln"?", natural logarithm":""}`:`${b.title} of ${M}`,N=m&&T?T.filter(I=>I<.05).length:null;return x(Et,{children:[x("div",{class:"tools",children:[x("label",{children:["Contrast"," ",x("select",{value:r,onChange:I=>o(I.currentTarget.value),children:s.map(I=>x("option",{value:I,children:I}))})]}),x("label",{children:["Measure"," ",x("select",{value:a,onChange:I=>l(I.currentTarget.value),children:i.filter(I=>I.contrast===r).map(I=>x("option",{value:I.measure,children:fv[I.measure]?.title??Zt(I.measure)}))})]}),x("label",{children:["Color by"," ",x("select",{value:b.name,onChange:I=>u(I.currentTarget.value),children:S.map(({name:I,title:U})=>x("option",{value:I,children:U}))})]}),x(Ti,{label:"Only corrected p < 0.05",checked:h,onChange:I=>f(I.currentTarget.checked)})]}),x(Ht,{text:v}),d===null?x("p",{class:"loading big",children:"Loading the map …"}):x(pv,{geometry:d.geometry,coloring:w?.coloring??null,id:"map",label:`The mean surface, colored by ${P}, contrast ${r}`,file:`${t}-${a}-${r}-${b.name}.png`,readout:I=>`vertex ${I} · ${S.map(({name:U,title:D,kind:V})=>`${D.split(" (")[0]} ${Re(m?.[U]?.[I])}${V==="effect"&&p==="mm"?" mm":""}`).join(" · ")}`}),x("div",{class:"legend",children:[w&&x(dm,{map:w.map,title:P,ticks:w.ticks}),x("p",{id:"map-says",children:[L&&`Smallest corrected p ${Re(L.smallest_p,2)}; ${Re(100*L.significant_share,2)} % of the surface below 0.05${N===null?"":` (${Re(N)} vertices)`}.`,b.kind!=="p"&&" Red: above zero; blue: below."," ",h&&"Gray: not below 0.05."]})]})]})}var fo=2;function xv({archive:n,result:e,name:t}){let{compactness:i}=e.found.model,s=v=>100*(i[v-1]-(i[v-2]??0)),r=i.map((v,g)=>g+1).filter(v=>n.has(`modes/mode-${v}-plus-2sd.vtk`)),[o,a]=pe(r[0]??1),[l,c]=pe(fo),[u,h]=pe(null),[f,d]=pe(null);sn(v=>{r.length!==0&&Promise.all(["minus","plus"].map(g=>n.bytes(`modes/mode-${o}-${g}-2sd.vtk`))).then(([g,_])=>{if(v.aborted)return;let[m,S]=[ho(g).geometry,ho(_).geometry],[b,T]=[m,S].map(w=>w.getAttribute("position").array),M=b.map((w,L)=>(w+T[L])/2),p=b.map((w,L)=>(T[L]-w)/(2*fo));h(w=>w?{...w,step:p}:(m.getAttribute("position").array.set(M),m.computeVertexNormals(),m.computeBoundingSphere(),{geometry:m,mean:M,normals:Float32Array.from(m.getAttribute("normal").array),step:p}))},g=>!v.aborted&&d(jt(g)))},[n,o]);let y=ai(()=>{if(u===null)return null;let{mean:v,normals:g,step:_}=u,m=Float32Array.from({length:v.length/3},(T,M)=>new X().fromArray(_,3*M).dot(new X().fromArray(g,3*M))),S=fo*gv(m);return{coloring:{values:m.map(T=>l*T),low:-S,high:S,map:"blue_red"},top:S,positions:v.map((T,M)=>T+l*_[M])}},[u,l]);return r.length===0?x("p",{class:"hint",children:"The model has no modes."}):x(Et,{children:[x("div",{class:"tools",children:[x("label",{children:["Mode"," ",x("select",{value:String(o),onChange:v=>a(Number(v.currentTarget.value)),children:r.map(v=>x("option",{value:String(v),children:[v,": ",Re(s(v))," % of the variance"]}))})]}),x("label",{class:"slider",children:["−",fo," SD"," ",x("input",{type:"range",min:-fo,max:fo,step:.1,value:l,"aria-label":"Standard deviations along the mode","aria-valuetext":`${l.toFixed(1)} standard deviations`,onInput:v=>c(Number(v.currentTarget.value))})," +",fo," SD"]}),x("button",{onClick:()=>c(0),children:"Mean"})]}),x(Ht,{text:f}),u===null?x("p",{class:"loading big",children:"Loading the mode …"}):x(pv,{geometry:u.geometry,coloring:y.coloring,positions:y.positions,id:"mode",label:`The mean shape, moved by ${l.toFixed(1)} standard deviations along mode ${o}`,file:`${t}-mode-${o}-${l.toFixed(1)}sd.png`,readout:v=>`vertex ${v} · ${Re(y.coloring.values[v])} mm along the normal of the mean`}),x("div",{class:"legend",children:[y&&x(dm,{map:"blue_red",title:"displacement along the normal of the mean, mm",ticks:mv(y.top)}),x("p",{children:["The mean ",l===0?"itself":`and ${l>0?"+":"−"}${Math.abs(l).toFixed(1)} standard deviations`," along mode ",o,", which explains ",Re(s(o))," % of the variance. Red: outwards; blue: inwards."]})]})]})}var pR={model:{text:"in the model",tone:"good"},scored:{text:"compared with the model",tone:"good"},unreliable:{text:"left out: match not reliable",tone:"bad"},dropped:{text:"excluded by decision",tone:"neutral"},failed:{text:"no match",tone:"bad"}};function mR({flags:n="",reasons:e="",error:t=""}){let i=n.split("; ").filter(Boolean),s=[Zt(e).replaceAll(";",","),t].filter(Boolean).join(", ");return i.map((r,o)=>o===0&&s!==""?`${r} (${s})`:r).join(", ")||s}var pm=100;function yv({study:n,rows:e,matches:t,deciding:i,picture:s,version:r,top:o}){let[a,l]=pe(null),[c,u]=pe(pm),[h,f]=pe(!1),d=new Map((n.subjects??[]).map(g=>[g.id,g])),y=e??(n.subjects??[]).map(({id:g})=>({id:g})),v=y.filter(g=>!h||g.flags||d.get(g.id)?.decision);return y.length===0?null:x("section",{"aria-label":"Quality control",class:"section",children:[x("h2",{children:"Quality control"}),x("div",{class:"tools",children:[x("span",{class:"hint",children:e===null?"The subjects and their matches.":`The most urgent first. Pictures: the template bent onto the subject; red lies outside of the mean (${Re(o,2)} mm or more), blue inside.`}),e!==null&&x("label",{class:"check",children:[x("input",{type:"checkbox",checked:h,onChange:g=>f(g.currentTarget.checked)})," Only those to look at, or decided"]})]}),x("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:x("table",{class:"quality",children:[x("thead",{children:x("tr",{children:[x("th",{scope:"col",children:"Subject"}),e!==null&&x(Et,{children:[x("th",{scope:"col",children:"Shape"}),x("th",{scope:"col",children:"Place"}),x("th",{scope:"col",children:"Look at"}),x("th",{scope:"col",class:"numeric",children:"Residual, mm"}),x("th",{scope:"col",class:"numeric",children:"Turned over, %"}),x("th",{scope:"col",class:"numeric",children:"Unusual, p"})]}),x("th",{scope:"col",children:"Match"}),x("th",{scope:"col",children:"Decision"})]})}),x("tbody",{children:v.slice(0,c).map(g=>{let _=g.id,m=t.get(_),S=pR[g.place??""],b=d.get(_),T=g.place!=="failed";return x("tr",{"data-subject":_,"data-place":g.place,children:[x("th",{scope:"row",children:_}),e!==null&&x(Et,{children:[x("td",{children:s&&T&&x(Kh,{name:`${r}/${_}`,alt:`Shape of ${_}`,load:()=>s(_)})}),x("td",{children:S&&x(Gn,{tone:S.tone,children:S.text})}),x("td",{class:"why",children:mR(g)}),x("td",{class:"numeric",children:T?Number(g.residual_mm).toFixed(3):""}),x("td",{class:"numeric",children:T?(100*Number(g.folded)).toFixed(2):""}),x("td",{class:"numeric",children:g.mahalanobis_p?Re(Number(g.mahalanobis_p),2):""})]}),x("td",{children:m&&x("a",{href:`#/jobs/${m.id}`,children:m.state})}),x("td",{class:"decision",children:a===_?x(gR,{subject:_,cancel:()=>l(null),decide:async(M,p)=>{await i.decide(_,M,p),l(null)}}):b?.decision?x(Et,{children:[x(Gn,{tone:b.decision==="kept"?"good":"neutral",children:b.decision==="kept"?"keep":"exclude"})," ",b.reason," ",x("button",{"aria-label":`Take back the decision about ${_}`,onClick:()=>{i.undo(_).catch(()=>{})},children:"Take back"})]}):x("button",{"aria-label":`Decide about ${_}`,onClick:()=>l(_),children:"Decide …"})})]},_)})})]})}),v.length===0&&x("p",{class:"empty",children:"Nobody is to be looked at."}),v.length>c&&x("button",{onClick:()=>u(c+pm),children:["Further ",Re(Math.min(pm,v.length-c))," of ",Re(v.length)]})]})}function gR({subject:n,decide:e,cancel:t}){let[i,s]=pe("dropped"),[r,o]=pe(""),[a,l]=pe(!1),c=Xt(null);ig(()=>c.current?.focus(),[]);let u=async h=>{h.preventDefault(),l(!0),await e(i,r.trim()).catch(()=>l(!1))};return x("form",{class:"tools","aria-label":`Decision about ${n}`,onSubmit:u,onKeyDown:h=>h.key==="Escape"&&t(),children:[x("select",{"aria-label":"Decision",value:i,ref:c,onChange:h=>s(h.currentTarget.value),children:[x("option",{value:"dropped",children:"exclude"}),x("option",{value:"kept",children:"keep"})]}),x("input",{"aria-label":"Reason",placeholder:"reason",required:!0,value:r,onInput:h=>o(h.currentTarget.value)}),x("button",{class:"primary",type:"submit",disabled:a,children:"Save"}),x("button",{type:"button",onClick:t,children:"Cancel"})]})}var _R=65536,xR=286,[yR,vR,bR,SR,MR]=[101010256,101075792,117853008,33639248,67324752],Jl=()=>new hi({type:"about:blank",title:"The archive of the study cannot be read",status:502}),rf=class n{constructor(e,t,i,s,r){this.path=e;this.etag=t;this.total=i;this.entries=s;this.signal=r}path;etag;total;entries;signal;static async open(e,t){let i=await Vn(e,{headers:{range:`bytes=-${_R}`},cache:"no-store",signal:t}),s=new DataView(await i.arrayBuffer()),r=i.headers.get("etag")??"",o=Number(/\/(\d+)$/.exec(i.headers.get("content-range")??"")?.[1]??s.byteLength),a=o-s.byteLength,l=s.byteLength-22;for(;l>=0&&s.getUint32(l,!0)!==yR;)l--;if(l<0)throw Jl();let[c,u,h]=[s.getUint16(l+10,!0),s.getUint32(l+12,!0),s.getUint32(l+16,!0)];if(l>=20&&s.getUint32(l-20,!0)===bR){let v=Number(s.getBigUint64(l-12,!0))-a;if(v<0||s.getUint32(v,!0)!==vR)throw Jl();[c,u,h]=[v+32,v+40,v+48].map(g=>Number(s.getBigUint64(g,!0)))}let f=new n(e,r,o,new Map,t),d=h>=a?new DataView(s.buffer,h-a,u):new DataView(await f.part(h,u)),y=0;for(let v=0;v<c;v++){if(d.getUint32(y,!0)!==SR)throw Jl();let[g,_,m]=[28,30,32].map(p=>d.getUint16(y+p,!0)),S=new TextDecoder().decode(new Uint8Array(d.buffer,d.byteOffset+y+46,g)),[b,T]=[d.getUint32(y+20,!0),d.getUint32(y+42,!0)],M=d.getUint32(y+24,!0);for(let p=y+46+g;p+4<=y+46+g+_;){let[w,L]=[d.getUint16(p,!0),d.getUint16(p+2,!0)],P=p+4,N=()=>Number(d.getBigUint64((P+=8)-8,!0));w===1&&(M===4294967295&&N(),b===4294967295&&(b=N()),T===4294967295&&(T=N())),p+=4+L}f.entries.set(S,{offset:T,size:b,nameLength:g,method:d.getUint16(y+10,!0)}),y+=46+g+_+m}return f}has(e){return this.entries.has(e)}names(){return[...this.entries.keys()]}async bytes(e){let t=this.entries.get(e);if(t===void 0||t.method!==0)throw Jl();let i=await this.part(t.offset,xR+t.nameLength+t.size),s=new DataView(i);if(s.getUint32(0,!0)!==MR)throw Jl();let r=30+s.getUint16(26,!0)+s.getUint16(28,!0);return i.slice(r,r+t.size)}async text(e){return new TextDecoder().decode(await this.bytes(e))}async part(e,t){let i=Math.min(this.total,e+t)-1,s=await Vn(this.path,{headers:{range:`bytes=${e}-${i}`,"if-range":this.etag},cache:"no-store",signal:this.signal}),r=await s.arrayBuffer();if(s.status===206)return r;if(s.headers.get("etag")!==this.etag)throw new hi({type:"about:blank",title:"The study was computed again: open it anew",status:409});return r.slice(e,i+1)}};async function wR(n,e){let t=new Map,i="";for(;i!==void 0;){let s=await Mt(`v1/jobs${vi({study:n,order:"asc",fields:"id,state,external_ref",page_size:500,page_token:i})}`,e);for(let r of s.jobs)r.external_ref&&t.set(r.external_ref,r);i=s.next_page_token}return t}function vv({id:n}){let[e,t]=pe(null),[i,s]=pe(new Map),[r,o]=pe(null),[a,l]=pe(null),[c,u]=pe(0),h=m=>l(jt(m)),f=Ui();sn(m=>{(async()=>{try{for(;;){let S=await Gi(()=>Mt(`v1/studies/${n}`,m),m);if(t(S),s(await Gi(()=>wR(n,m),m)),sf(S.state))break;await Wn(2e3,m),m.throwIfAborted()}}catch(S){m.aborted||h(S)}})()},[n,c]);let d=e?.state==="finished"?`${n}/${e.finished_at}`:null;if(sn(m=>{d!==null&&(async()=>{try{let[S,b]=await Promise.all([Gi(()=>rf.open(`v1/studies/${n}/archive`),m),Gi(()=>Mt(`v1/studies/${n}/result`,m),m)]),[T,M]=[hv(await S.text("quality.csv")),ho(await S.bytes("mean.vtk"))];m.aborted||o({archive:S,result:b,mean:M,rows:T,version:d})}catch(S){m.aborted||h(S)}})()},[d]),e===null)return a===null?x("p",{class:"loading",children:"Loading the study …"}):x(Ht,{text:a});let y=m=>(l(null),m.then(S=>{t(b=>({...b,...S})),u(b=>b+1)},S=>{throw h(S),S})),v=m=>`v1/studies/${n}/subjects/${encodeURIComponent(m)}/decision`,g={decide:(m,S,b)=>y($n("PUT",v(m),{decision:S,reason:b})),undo:m=>y($n("DELETE",v(m)))},_=e.external_ref??n.slice(-8);return x("article",{class:"study",children:[x("h1",{class:"sub",children:["Study ",e.external_ref??x("code",{children:n})," ",x(hm,{state:e.state})]}),x(ER,{study:e,found:r,cancel:()=>{y($n("POST",`v1/studies/${n}/cancel`)).catch(()=>{})}}),x(Ht,{text:a}),x("div",{class:"columns",children:[x(CR,{study:e,matches:i,hasResult:r!==null}),x("section",{class:"card",children:[x("h2",{children:"The study"}),x(Jn,{rows:[["Subjects",Re(e.n_subjects)],["Method of the matches",e.method],...TR(r?.result),["Created",`${new Date(e.created_at).toLocaleString()}, ${ms(e.created_at,f)} ago`],...e.finished_at?[["Finished",new Date(e.finished_at).toLocaleString()]]:[],...Object.entries(e.labels).map(([m,S])=>[`Label ${m}`,S])]})]}),e.state==="finished"&&x("section",{class:"card",children:[x("h2",{children:"Report and files"}),x("div",{class:"saves",children:[x("button",{onClick:()=>Rf(`v1/studies/${n}/report`,!0).catch(h),children:"Open the report"}),x("button",{onClick:()=>Rf(`v1/studies/${n}/archive`,!1).catch(h),children:"Save the archive, ZIP"}),x("button",{onClick:()=>dc(`v1/studies/${n}/result`,`study-${_}.json`).catch(h),children:"Save the result, JSON"})]}),x("p",{class:"soft",children:"The report is one page to print; the archive has all tables, surfaces, maps, modes and labels."})]})]}),x(yv,{study:e,rows:r?.rows??null,matches:i,deciding:g,top:r?bv(r.result):0,picture:r&&(async m=>d===r.version?AR(r,m):null),version:r?.version??n}),r!==null&&x(Et,{children:[x("section",{class:"card section","aria-label":"Maps",children:[x("h2",{children:"Maps on the mean surface"}),x(_v,{archive:r.archive,result:r.result,name:`study-${_}`},r.version)]}),x("section",{class:"card section","aria-label":"Modes",children:[x("h2",{children:"Modes of the shape model"}),x(xv,{archive:r.archive,result:r.result,name:`study-${_}`},r.version)]})]})]})}function TR(n){let e=n?.settings.analysis;return e?[["Effect",e.effect??"none asked for"],...e.adjust?.length?[["Adjusted for",e.adjust.join(", ")]]:[],...e.effect&&e.permutations?[["Permutations",Re(e.permutations)]]:[]]:[]}var bv=({found:n})=>2*Math.sqrt(n.model.variances_mm2.reduce((e,t)=>e+t,0))||1;async function AR({archive:n,mean:e,result:t},i){let s=`subjects/${i}.vtk`;if(!n.has(s))return null;let{geometry:r,arrays:o}=ho(await n.bytes(s)),a=o.normal_displacement,l=bv(t);return{geometry:r,frame:Xy(r,e.geometry),coloring:a&&{values:a,low:-l,high:l,map:"blue_red"}}}function ER({study:n,found:e,cancel:t}){let i=n.state==="finished",s=(e?.rows??[]).filter(h=>h.flags!==""&&h.decision==="").length,r=e?.result.found.subjects,o=r&&[`${Re(r.model)} in the shape model`,...r.scored?[`${Re(r.scored)} compared with it`]:[],...r.unreliable?[`${Re(r.unreliable)} left out: match not reliable`]:[],...r.dropped?[`${Re(r.dropped)} excluded by decision`]:[],...r.failed?[`${Re(r.failed)} without a match`]:[]],a=n.state==="failed"||i&&s>0?"bad":i?"good":n.state==="cancelled"?"neutral":"wait",l=fm(n),c=i?e===null?"Finished":s>0?`${Re(s)} of ${Re(n.n_subjects)} to look at`:"No subject stands out":l[0].toUpperCase()+l.slice(1),u=i?s>0?"Look at the subjects at the head of the table; exclude those that are wrong, and keep those that are right.":"Look at the maps, then open the report.":n.state==="failed"?"Correct what is said above, or add subjects, and submit it again.":n.state==="cancelled"?"Submit it again; matches that are finished are not computed twice.":"Quality control, maps and modes appear here when it is finished.";return x("section",{class:`verdict ${a}`,"aria-label":"Verdict",children:[x("span",{class:"mark","aria-hidden":"true",children:{good:"✓",bad:"✕",neutral:"–",wait:"…"}[a]}),x("div",{role:"status",children:[x("p",{class:"title",id:"verdict",children:c}),i&&o&&x("p",{children:[o.join(", "),"."]}),n.error&&x("p",{children:[n.error.title,n.error.detail].filter(Boolean).join(": ")}),x("p",{class:"next",children:[x("b",{children:"Next:"})," ",u]})]}),x("div",{class:"actions",children:!sf(n.state)&&x("button",{onClick:t,children:"Cancel"})})]})}function CR({study:n,matches:e,hasResult:t}){let{state:i,progress:s}=n,r=i==="finished"?3:i==="modelling"?2:i==="matching"&&s.template_round===0?1:0,o=i==="failed"||i==="cancelled",a=u=>o?t?"done":"not reached":u<r?"done":u===r?"now":"to come",l=[[s.template_round>0?`Template, round ${s.template_round}`:"Template",a(0)],["Matches with all subjects",a(1)],["Shape model, statistics and report",a(2)]],c=new Map;for(let{state:u}of e.values())c.set(u,(c.get(u)??0)+1);return x("section",{class:"card",children:[x("h2",{children:"Steps and matches"}),x("ol",{class:"steps",children:l.map(([u,h])=>x("li",{class:h.replace(" ","-"),"aria-current":h==="now"?"step":void 0,children:[u,": ",x("b",{children:h})]}))}),i==="matching"&&x("p",{children:[x(Ji,{share:s.matches_done/Math.max(1,s.matches_total),label:"Matches that are finished"})," ",Re(s.matches_done)," of ",Re(s.matches_total)]}),x("p",{id:"matches",children:[[...c].map(([u,h])=>`${Re(h)} ${Zt(u)}`).join(", ")||"No match yet",". ",x("a",{href:`#/jobs?study=${n.id}`,children:"All matches"})]})]})}function Sv({ply:n,fault:e,name:t}){let i=Xt(null),s=Hr(),[r,o]=pe(null);return mt(()=>{let a=i.current,l;try{l=new ws({canvas:a,antialias:!0})}catch{o("This browser cannot draw in 3D.");return}let{geometry:c}=Aa(n),u=Es(c),h=c.boundingSphere?.radius||1,f=new ns,d=new Mn(c,new Ml({color:9417945,side:di}));f.add(d,new El(16777215,8952234,1.4));let y=new Rl(16777215,1.6);if(f.add(y),e){let P=(N,I)=>{let U=new Mn(new vr(h*N,24,16),new qs({color:14024812,transparent:!0,opacity:I,depthTest:!1}));U.position.set(...e),U.renderOrder=1,f.add(U)};P(.03,1),P(.1,.35)}l.setPixelRatio(Math.min(2,devicePixelRatio));let v=new Ii(-1,1,1,-1,-20*h,40*h),[g,_,m]=u.axes;v.up.copy(_);let S=e&&new X(...e).sub(u.center).dot(m)<0?-4:4;v.position.copy(u.center).addScaledVector(m,S*h).addScaledVector(g,1e-4),v.lookAt(u.center);let b=new Pr(v,a);b.target.copy(u.center),b.staticMoving=!0,b.rotateSpeed=3;let T=!0;b.addEventListener("change",()=>T=!0);let M=()=>{let{clientWidth:P,clientHeight:N}=a;if(P===0)return;l.setSize(P,N,!1);let I=Math.max(1.1*(u.high.x-u.low.x)/P,1.2*(u.high.y-u.low.y)/N)/2||h/N;[v.left,v.right,v.top,v.bottom]=[-I*P,I*P,I*N,-I*N],v.updateProjectionMatrix(),b.handleResize(),T=!0},p=new ResizeObserver(M);p.observe(a);let w=0,L=()=>{w=requestAnimationFrame(L),b.update(),T&&(T=!1,y.position.copy(v.position).sub(u.center),l.setClearColor(new st(getComputedStyle(a).getPropertyValue("--canvas").trim()||"#f4f6f8")),l.render(f,v))};return M(),L(),()=>{cancelAnimationFrame(w),p.disconnect(),b.dispose(),c.dispose(),l.dispose()}},[n,e?.join(),s]),r===null?x("canvas",{class:"preview",ref:i,role:"img","aria-label":`The ${t} surface${e?", the place of the fault is marked":""}`}):x("p",{class:"failure",children:r})}var Mv=["source","target"],RR=128<<20;function Tv(){let[n,e]=pe({source:null,target:null}),[t,i]=pe([]),[s,r]=pe({}),[o,a]=pe("balanced"),[l,c]=pe({}),[u,h]=pe(0),[f,d]=pe(""),[y,v]=pe(""),[g,_]=pe([]),[m,S]=pe(null),[b,T]=pe(null),[M,p]=pe(!1),[w,L]=Bo("names","no");mt(()=>{Mt("v1/methods").then(({methods:G})=>i(G),G=>S(jt(G))),Mt("openapi.json").then(({components:G})=>r(G.schemas),G=>S(jt(G)))},[]);let P=(G,j)=>e(te=>({...te,[G]:{...te[G]??{name:"",mesh:null,ply:null,failure:null},...j}})),N=async(G,j,te)=>{T(null),P(G,{name:te,mesh:null,ply:null,failure:null});try{let K=await(await Vn(`v1/meshes?file_name=${encodeURIComponent(PR(te))}`,{method:"POST",body:j,headers:{"content-type":"application/octet-stream"}})).json();if(P(G,{mesh:K}),K.n_bytes>RR)return;let q=await Vn(`v1/meshes/${K.id}/surface`).catch(()=>null);q&&P(G,{ply:await q.arrayBuffer()})}catch(ue){P(G,{failure:jt(ue)})}},I=(G,j)=>{if(j.length<2)return j.forEach(q=>{N(G,q,q.name)});let[te,ue]=[...j].sort((q,le)=>q.name.localeCompare(le.name)),K=/target|fixed|reference/i.test(te.name)||/source|moving/i.test(ue.name);N("source",K?ue:te,(K?ue:te).name),N("target",K?te:ue,(K?te:ue).name)},U=()=>Mv.forEach(G=>{let j=`${G}.nii.gz`;fetch(fc(`phantoms/${j}`)).then(async te=>{N(G,await te.blob(),j)},te=>P(G,{failure:jt(te)}))}),{source:D,target:V}=n,Y=!!(D?.mesh&&V?.mesh),W=async G=>{p(!0),S(null),_([]),T(null);try{let j=y.split(/[\s,]+/).filter(Boolean).map(K=>[K.slice(0,K.indexOf(":")),K.slice(K.indexOf(":")+1)]),te={source:{mesh_id:D.mesh.id},target:{mesh_id:V.mesh.id},parameters:OR({method:o,...l}),priority:u,labels:{...w==="yes"?{source_file:wv(D.name),target_file:wv(V.name)}:{},...Object.fromEntries(j)},...f===""?{}:{external_ref:f}},ue=await $n("POST",`v1/jobs${G?"?validate_only=true":""}`,te);G?S(""):ji(`jobs/${ue.id}`)}catch(j){if(S(jt(j)),j instanceof hi){let{errors:te,input:ue,detail:K,title:q,place_mm:le}=j.problem;_(te??[]),(ue==="source"||ue==="target")&&T({side:ue,text:K??q,place:le??null})}}finally{p(!1)}},ae=t.find(({name:G})=>G===o);return x("div",{class:"submit",children:[x("h1",{children:"Submit a pair"}),x("p",{class:"tools",children:[x("span",{children:"The source is moved and bent onto the target, which stays."}),x("button",{onClick:U,children:"Take the two built-in phantoms"})]}),x("div",{class:"pair",children:Mv.map(G=>x(IR,{side:G,given:n[G],refusal:b?.side===G?b:null,take:j=>I(G,j)},G))}),x("section",{class:"card",children:[x("h2",{children:"Method"}),x("div",{class:"tools",children:[x("label",{children:["Method"," ",x("select",{value:o,onChange:G=>{a(G.currentTarget.value),c({})},children:t.map(({name:G})=>x("option",{value:G,children:G}))})]}),x("label",{children:["Priority ",x("input",{type:"number",min:-100,max:100,value:u,onInput:G=>h(Number(G.currentTarget.value))})]}),x("label",{children:["Reference ",x("input",{value:f,onInput:G=>d(G.currentTarget.value)})]}),x("label",{children:["Labels ",x("input",{placeholder:"study:baseline",value:y,onInput:G=>v(G.currentTarget.value)})]})]}),x("p",{children:[x(Ti,{label:"Keep the names of the files with the job",checked:w==="yes",onChange:G=>L(G.currentTarget.checked?"yes":"no")})," ",x("span",{class:"soft",children:"They tell jobs apart in the list. Not for names that identify people: whoever may read the job reads them."})]}),x("p",{children:ae?.description}),ae&&x(LR,{method:ae,schemas:s,changed:l,change:c,faults:g})]}),m===""?x("p",{class:"success",role:"status",children:"These files and parameters are accepted."}):x(Ht,{text:m}),x("div",{class:"tools send",children:[x("button",{class:"primary",disabled:!Y||M,onClick:()=>{W(!1)},children:"Match them"}),x("button",{disabled:!Y||M,onClick:()=>{W(!0)},children:"Only check"}),!Y&&x("span",{class:"hint",children:"Both surfaces are needed."})]})]})}function wv(n){let e=n;for(;new TextEncoder().encode(e).length>256;)e=e.slice(1);return e}var PR=n=>`file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(n)?.[0]??""}`;function IR({side:n,given:e,refusal:t,take:i}){let[s,r]=pe(!1),o=e?.mesh,a=o?.report?.topology??o?.problem?.topology,l=t?.place??o?.problem?.place_mm??null,c=t?.text??(o?.problem?o.problem.detail??o.problem.title:null);return x("section",{class:`card drop ${s?"over":""}`,"aria-label":n,onDragOver:u=>{u.preventDefault(),r(!0)},onDragLeave:()=>r(!1),onDrop:u=>{u.preventDefault(),r(!1),i([...u.dataTransfer?.files??[]])},children:[x("h2",{children:n==="source"?"Source":"Target"}),x("label",{class:"file",children:[e===null?"Drop a file here, or choose one: ":`${e.name}${o?`, ${pc(o.n_bytes)}`:""} `,x("input",{type:"file","aria-label":`File of the ${n}`,onChange:u=>i([...u.currentTarget.files??[]])})]}),e===null&&x("p",{class:"hint",children:"Surfaces: GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3. Label volumes: NIfTI, MGZ, NRRD, MetaImage, DICOM SEG."}),e!==null&&o===null&&e.failure===null&&x("p",{class:"loading",children:"Sending and checking …"}),x(Ht,{text:e?.failure??null}),c&&x("p",{class:"failure",role:"alert",children:[x("b",{children:"With default parameters it is refused:"})," ",c,l&&". The place is marked."]}),o&&!c&&x("p",{class:"success",role:"status",children:"✓ It can be matched."}),e?.ply&&x(Sv,{ply:e.ply,fault:l,name:n}),a&&x(Jn,{rows:[["Format",o?.report?.format??"–"],["Vertices",Re(a.n_vertices)],["Faces",Re(a.n_faces)],["Pieces",Re(a.n_components)],["Genus",a.genus===null?"open":Re(a.genus)],["Boundary edges",Re(a.n_boundary_edges)],["Edges with more than two faces",Re(a.n_nonmanifold_edges)],["Area",`${Re(a.area_mm2)} mm²`],["Volume",a.volume_mm3===null?"–":`${Re(a.volume_mm3)} mm³`],["Repairs",o?.report?.repairs.length?String(o.report.repairs.length):"none"]]})]})}function LR({method:n,schemas:e,changed:t,change:i,faults:s}){let r=u=>{let h=u.$ref?.split("/").at(-1),f=h===void 0?void 0:e[h];if(f)return{...r(f),description:u.description??f.description};let d=[...u.oneOf??[],...u.anyOf??[]].filter(y=>y.type!=="null");return d.length===1?{...r(d[0]),description:u.description??d[0].description,type:[String(r(d[0]).type),"null"]}:u},o=u=>u.reduce((h,f)=>h===null||typeof h!="object"?void 0:h[f],n.defaults),a=(u,h,f)=>{let d={...t,[u]:h};JSON.stringify(h)===JSON.stringify(f)&&delete d[u],i(d)},l=(u,h)=>Object.entries(r(u).properties??{}).map(([f,d])=>{let y=r(d),v=[...h,f];if(v.join()==="method")return null;if(y.properties)return x("fieldset",{children:[x("legend",{children:Zt(f)}),y.description&&x("p",{class:"soft",children:y.description}),l(y,v)]},f);let g=v.join("."),_=o(v),m=g in t?t[g]:_,S=s.find(({pointer:b})=>b.replace(/^\/parameters/,"")===`/${v.join("/")}`);return x(DR,{name:g,schema:y,value:m,isChanged:g in t,fault:S,set:b=>a(g,b,_)},g)}),c=Object.keys(t).length;return x("details",{children:[x("summary",{children:["Parameters",c>0&&`: ${c} changed`]}),c>0&&x("button",{onClick:()=>i({}),children:"All as the method sets them"}),x("div",{class:"fields",children:l({$ref:"PartialParameters"},[])})]})}var NR=[[/_mm$/,"mm"],[/_deg$/,"°"],[/_ms$/,"ms"],[/_s$/,"s"],[/_bytes$/,"bytes"]];function DR({name:n,schema:e,value:t,isChanged:i,fault:s,set:r}){let[o,a]=pe(null),l=[e.type??[]].flat(),c=NR.find(([v])=>v.test(n))?.[1],u=l.includes("number")||l.includes("integer"),h=e.enum??e.oneOf?.flatMap(v=>v.const??v.enum??[]),f=Zt(n.split(".").at(-1)),d;h&&h.length>0&&!l.includes("array")?d=x("select",{value:t===null?"null":String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value),children:[(l.includes("null")||t===null)&&x("option",{value:"null",children:"not set"}),h.map(v=>x("option",{value:String(v),children:String(v)}))]}):l.includes("boolean")?d=x("select",{value:String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value==="true"),children:[(l.includes("null")||t===null)&&x("option",{value:"null",children:"not set"}),x("option",{value:"true",children:"yes"}),x("option",{value:"false",children:"no"})]}):u?d=x("input",{type:"number",step:l.includes("integer")?e.multipleOf??1:"any",min:e.minimum,max:e.maximum,placeholder:l.includes("null")?"not set":void 0,value:t==null?"":String(t),onChange:v=>r(v.currentTarget.value===""?null:Number(v.currentTarget.value))}):d=x("input",{value:o??JSON.stringify(t??null),spellcheck:!1,onInput:v=>a(v.currentTarget.value),onChange:v=>{try{r(JSON.parse(v.currentTarget.value)),a(null)}catch{}}});let y=[e.minimum!==void 0&&`at least ${Re(e.minimum)}`,e.maximum!==void 0&&`at most ${Re(e.maximum)}`].filter(Boolean).join(", ");return x("div",{class:`field ${i?"changed":""}`,children:[x("label",{children:[x("span",{children:[f," ",c&&x("span",{class:"soft",children:["(",c,")"]})]})," ",d]}),x("p",{class:"soft",children:[e.description," ",y&&`(${y})`]}),s&&x(Ht,{text:s.detail})]})}function OR(n){let e={};for(let[t,i]of Object.entries(n)){let s=t.split("."),r=s.pop(),o=s.reduce((a,l)=>a[l]??={},e);o[r]=i}return e}var Av=[["jobs","Jobs"],["submit","Submit"],["batches","Batches"],["studies","Studies"],["operations","Operations"]],Ev="homolog-theme";function FR(){let[n,e]=pe(localStorage.getItem(Ev)??"auto");return mt(()=>{n==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,localStorage.setItem(Ev,n),window.dispatchEvent(new Event("theme"))},[n]),[n,e]}function UR({done:n}){let[e,t]=pe(""),[i,s]=pe(null);return x("form",{class:"card key",onSubmit:async o=>{o.preventDefault(),Fr.set(e.trim());try{await Mt("v1/jobs?page_size=1"),n()}catch(a){Fr.set(null),s(jt(a))}},children:[x("h1",{children:"This service asks for a key"}),x("p",{children:["Paste an API key of your tenant. It is kept for this tab only, until you close it. Whoever operates the service creates keys with ",x("code",{children:"homolog keys create"}),"."]}),x("label",{children:["API key ",x("input",{type:"password",autocomplete:"off",spellcheck:!1,value:e,onInput:o=>t(o.currentTarget.value),required:!0})]}),x(Ht,{text:i}),x("button",{class:"primary",type:"submit",children:"Open"})]})}function BR(){let{path:n,query:e}=D0(),[t,i]=pe(!1),[s,r]=pe(""),[o,a]=FR();mt(()=>rg(()=>i(!0)),[]),mt(()=>{Mt("healthz").then(({version:h})=>r(h),()=>{})},[]);let[l="jobs",c]=n;mt(()=>{let h=Av.find(([f])=>f===l)?.[1]??"Dashboard";document.title=c?`${{batches:"Batch",studies:"Study"}[l]??"Job"} ${c.slice(-8)} · homolog`:`${h} · homolog`},[l,c]);let u;return t?u=x(UR,{done:()=>i(!1)}):l==="jobs"&&c!==void 0?u=x(av,{id:c},c):l==="jobs"?u=x(Zy,{query:e}):l==="submit"?u=x(Tv,{}):l==="batches"&&c!==void 0?u=x(tv,{id:c},c):l==="batches"?u=x(ev,{}):l==="studies"&&c!==void 0?u=x(vv,{id:c},c):l==="studies"?u=x(uv,{}):l==="operations"?u=x(cv,{}):u=x("p",{class:"failure",children:"There is no view of this name. Choose one above."}),x(Et,{children:[x("a",{class:"skip",href:"#main",onClick:h=>(h.preventDefault(),document.getElementById("main")?.focus()),children:"Skip to the content"}),x("header",{children:[x("a",{class:"name",href:"#/jobs",children:"homolog"}),x("nav",{"aria-label":"Views",children:Av.map(([h,f])=>x("a",{href:`#/${h}`,"aria-current":h===l?"page":void 0,children:f}))}),x("span",{class:"end",children:[x("label",{children:[x("span",{class:"quiet",children:"Theme"})," ",x("select",{value:o,onChange:h=>a(h.currentTarget.value),children:[x("option",{value:"auto",children:"auto"}),x("option",{value:"light",children:"light"}),x("option",{value:"dark",children:"dark"})]})]}),Fr.get()!==null&&x("button",{onClick:()=>{Fr.set(null),i(!0)},children:"Forget key"})]})]}),x("main",{id:"main",tabIndex:-1,children:u}),x("footer",{children:["homolog ",s," · ",x("a",{href:new URL("docs/",document.baseURI.split("#")[0]).href,children:"API"})," · ",x("a",{href:new URL("assets/licenses.txt",document.baseURI.split("#")[0]).href,children:"licenses"})]})]})}$m(x(BR,{}),document.getElementById("app"));
