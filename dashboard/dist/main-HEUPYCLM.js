var zt,fg,Yb,hr,If,fc,dg,lc,pg,Nf,Lf,jb,Va=Symbol.for("pv"),dc={},pc=[],Jb=/^m(i|n|o|s|text|space)$/,Df=Array.isArray,mg=pc.slice,kr=Object.assign;function Br(n){n&&n.parentNode&&n.remove()}function cc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Va,__v:s||++fg,__i:-1,__u:0};return!s&&zt.vnode&&zt.vnode(r),r}function mt(n){return n.children}function uc(n,e){this.props=n,this.context=e,this.__g=0}function fr(n,e){if(e==null)return n.__&&fr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:fr(n)}function Zb(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=kr({constructor:Va},t)).__v=t.__v+1,zt.vnode&&zt.vnode(e),Ff(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||fr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,bg(s,e,r),t.__=t.__e=null,e.__e!=i&&gg(e))}function gg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),gg(n)}function ug(n){(8&n.__g||(n.__g|=8,hr.push(n),fc++))&&If==zt.debounceRendering||((If=zt.debounceRendering)||queueMicrotask)(_g)}function _g(){try{for(var n,e=1;hr.length;)hr.length>e&&hr.sort(dg),n=hr.shift(),e=hr.length,8&n.__g&&Zb(n)}finally{(fc=hr.length)&&(If||queueMicrotask)(_g)}}function xg(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,y,v,g,x=i.__k||pc,_=e.length;for(l=Kb(t,e,x,l,_),h=0;h<_;h++)(d=t.__k[h])!=null&&(f=~d.__i&&x[d.__i]||dc,d.__i=h,g=Ff(n,d,f,s,r,o,a,l,c,u),y=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&Of(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||y,d)),v=v||y,4&d.__u?(l=yg(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:y&&(l=y.nextSibling),d.__u&=-21);return t.__e=v,l}function Kb(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,y=t.length,v=y,g=0,x=0,_=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=_[r]=cc(null,o):Df(o)?o=_[r]=cc(mt,{children:o}):o.constructor===Va&&o.__b?o=_[r]=cc(o.type,o.props,o.key,o.ref,o.__v):_[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Qb(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,x=1)):(~c||(s>y?g--:s<y&&g++),typeof o.type!="function"&&(o.__u|=4))):_[r]=null;if(x){for(u=[],h=[],r=0;r<s;r++)if((o=_[r])&&16&o.__u){for(g=0,f=u.length;g<f;)u[d=g+f>>1]<o.__i?g=d+1:f=d;u[g]=o.__i,h[r]=g+1}for(g=u.length;r--;)h[r]&&(h[r]==g?g--:_[r].__u|=4)}if(v)for(r=0;r<y;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=fr(a)),Uf(a,a));return i}function yg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=yg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=fr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Qb(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function hg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function ac(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||hg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||hg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Lf[e]||(Lf[e]=eS(e)),(n.__a||(n.__a={}))[e]=Nf,r=e!=(e=e.replace(pg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function eS(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[lc]==null)e[lc]=Nf++;else if(e[lc]<this.__a[n])return;return t(zt.event?zt.event(e):e)}}}function Ff(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,y,v,g,x,_,M,S,T,b,m,w,R,C,I,E=e.type;if(e.constructor!==Va)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=hc(u,r):r.push(u),a=r[0]||a),(u=zt.__b)&&u(e);e:if(typeof E=="function"){f=o.length;try{if(x=e.props,_=(u=E.prototype)&&u.render,M=(u=E.contextType)&&i[u.__c],S=u?M?M.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(_?e.__c=d=new E(x,S):(e.__c=d=new uc(x,S),d.constructor=E,d.render=nS),M&&M.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),_&&(d.__s||(d.__s=d.state),E.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=kr({},d.__s)),kr(d.__s,E.getDerivedStateFromProps(x,d.__s)))),y=d.props,v=d.state,d.__v=e,t.__c){if(x!==y&&_&&!E.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(x,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(x,d.__s,S)===!1){e.__v!=t.__v&&(d.props=x,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(F){F&&(F.__=e)}),pc.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=fr(t);break e}d.componentWillUpdate&&d.componentWillUpdate(x,d.__s,S),_&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(y,v,g)})}else _&&!E.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),_&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=x,d.__P=n,d.__g&=-5,T=zt.__r,b=_?25:0;do d.__g&=-9,T&&T(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++b<25);_&&(pc.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=kr({},i,d.getChildContext())),_&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(y,v)),m=u&&u.type===mt&&u.key==null?u.props.children:u,x.__P&&(u=a,s=(n=x.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(F){F&&Uf(F,F)}),t.__k=null),a=t.__k?fr(t,0):null),a=xg(n,Df(m)?m:[m],e,t,i,s,r,o,a,l,c),x.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Br),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(F){if(o.length=f,e.__v=null,l||r)if(F&&F.then){if(e.__u|=128|l,r){for(~(C=r.indexOf(a||void 0))||(C=r.length);(I=r[C-1])&&I.nodeType==8;)C--;for(;C<r.length;C++)if(I=r[C])if(r[C]=null,w){if(I==R)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(R=hc(w=I))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=hc(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Br);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),F&&F.then||vg(e),zt.__e(F,e,t)}}else a=e.__e=tS(t.__e,e,t,i,s,r,o,l,c,n);return(u=zt.diffed)&&u(e),a}function hc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function vg(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(vg))}function bg(n,e,t){for(var i=0;i<t.length;)Of(t[i++],t[i++],t[i++]);zt.__c&&zt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){zt.__e(r,s.__v)}})}function tS(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,y,v,g,x,_=t.props||dc,M=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((y=r[u])&&(S?y.localName==S:y.nodeType==3)){n=y,r[u]=null;break}}if(!n){if(x=c.ownerDocument||document,!S)return x.createTextNode(M);n=x.createElementNS(s,S,M.is?M:c),a&&(zt.__m&&zt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&M.defaultValue!=null?null:r&&mg.call(c.childNodes),!a&&r)for(_={},u=0;u<n.attributes.length;u++)_[(y=n.attributes[u]).name]=y.value;for(u in _)y=_[u],u=="dangerouslySetInnerHTML"?f=y:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||ac(n,u,null,y,s);for(u in M)y=M[u],u=="children"?d=y:u=="dangerouslySetInnerHTML"?h=y:u=="value"?v=y:u=="checked"?g=y:a&&typeof y!="function"||_[u]===y||ac(n,u,y,_[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Jb.test(S))&&(s="http://www.w3.org/1999/xhtml"),xg(c,Df(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&fr(t,0),a,l),r&&r.some(Br)),a&&S!="textarea"||(u="value",S=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(S!="progress"||v)||ac(n,u,v,_[u],s),u="checked",g!=null&&g!=n[u]&&ac(n,u,g,_[u],s))}else _===M||a&&n.data==M||(n.data=M);return n}function Of(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){zt.__e(s,t)}}function Uf(n,e,t){var i,s,r,o;if(zt.unmount&&zt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Of(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){zt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Uf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=hc(i,r=[]))&&(i==n.__e&&r.some(Br),Br(s),Br(i)),t||Br(n.__e),n.__e=n.__c=n.__=null}function nS(n,e,t){return this.constructor(n,t)}function Sg(n,e){var t,i,s,r;zt.__&&zt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=cc(mt,{children:[n]}),s=[],r=[],Ff(e,e.__k,i||dc,dc,e.namespaceURI,i?null:e.firstChild?mg.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),bg(s,e.__k,r),e.__k.props.children=null}zt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw fc=0,n}},fg=0,Yb=function(n){return n!=null&&n.constructor===Va},uc.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=kr({},this.state)),typeof n=="function"&&(n=n(kr({},t),this.props)),n&&(kr(t,n),this.__v&&(e&&this.__k.push(e),ug(this)))},uc.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),ug(this))},uc.prototype.render=mt,hr=[],fc=0,dg=function(n,e){return n.__v.__b-e.__v.__b},lc=Symbol(),pg=/(PointerCapture)$|Capture$/i,Nf=0,Lf={},jb=0;var Ro,Sn,Bf,Mg,kf=Object.is,mc=0,Lg=[],zf=[],mn=zt,wg=mn.__b,Tg=mn.__r,Ag=mn.diffed,Eg=mn.__c,Cg=mn.unmount,Rg=mn.__;function gc(n,e){mn.__h&&mn.__h(Sn,n,mc||e),mc=0;var t=Sn.__H||(Sn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function ae(n){return mc=1,iS(Dg,n)}function iS(n,e,t){var i=gc(Ro++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Dg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);kf(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Sn,!Sn.__f)){Sn.__f=!0;var s=Sn.shouldComponentUpdate;Sn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,kf(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function ct(n,e){var t=gc(Ro++,3);!mn.__s&&Gf(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Sn.__H.__h.push(t))}function Ng(n,e){var t=gc(Ro++,4);!mn.__s&&Gf(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,Sn.__h.push(t))}function wt(n){return mc=5,Qt(function(){return{current:n}},[])}function Qt(n,e){var t=gc(Ro++,7);return Gf(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function sS(){var n;do{for(;n=zf.shift();)try{Ga(n)}catch(t){mn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Lg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ga),e.__h.some(Vf),e.__h=[]}catch(t){e.__h=[],mn.__e(t,n.__v)}}}while(zf.length)}mn.__b=function(n){Sn=null,wg&&wg(n)},mn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Rg&&Rg(n,e)},mn.__r=function(n){Tg&&Tg(n),Ro=0;var e=(Sn=n.__c).__H;e&&(Bf==Sn?Sn.__h=[]:(e.__h.some(Ga),e.__h.some(Vf),Ro=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Bf=Sn},mn.diffed=function(n){Ag&&Ag(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Ig(Lg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Bf=Sn=null},mn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ga),t.__h=t.__h.filter(function(i){return!i.__||Vf(i)})}catch(i){t.__h=[function(){throw i}]}}),Eg&&Eg(n,e)},mn.unmount=function(n){Cg&&Cg(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Ig(zf.push(s))}else Ga(s)}catch(r){e=r}}),i.__H=void 0,e&&mn.__e(e,i.__v))};var Pg=typeof requestAnimationFrame=="function";function rS(n){var e,t=function(){clearTimeout(i),Pg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Pg&&(e=requestAnimationFrame(t))}function Ig(n){n!=1&&Mg==mn.requestAnimationFrame||((Mg=mn.requestAnimationFrame)||rS)(sS)}function Ga(n){var e=Sn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Sn=e}function Vf(n){var e=Sn;n.__c=n.__(),Sn=e}function Gf(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!kf(t,n[i])})}function Dg(n,e){return typeof e=="function"?e(n):e}var xc=["queued","running","succeeded","failed","cancelled","expired","dead"],yc=n=>n.quantity??(n.phase==="displacement"&&n.energy!==void 0?"field_energy":"curvature_energy"),gs=n=>[yc(n),n.start??"",n.round,n.phase].join("/"),zn=class extends Error{constructor(t){super(t.detail??t.title);this.problem=t}problem},Hf="homolog-key",_c=[],zr={get:()=>sessionStorage.getItem(Hf),set(n){n===null?sessionStorage.removeItem(Hf):sessionStorage.setItem(Hf,n)}};function Fg(n){return _c.push(n),()=>{_c=_c.filter(e=>e!==n)}}var vc=n=>new URL(n,document.baseURI.split("#")[0]);async function Mn(n,e={}){let t=new Headers(e.headers),i=zr.get();i!==null&&t.set("authorization",`Bearer ${i}`);let s=await fetch(vc(n),{...e,headers:t,cache:e.cache??"no-cache"});if(s.status===401&&_c.forEach(o=>o()),s.ok||s.status===304)return s;let r={type:"about:blank",title:s.statusText,status:s.status};try{r=await s.json()}catch{}throw new zn(r)}async function vt(n,e){return(await Mn(n,{signal:e})).json()}async function Vn(n,e,t){let i={method:n};return t!==void 0&&(i.body=JSON.stringify(t),i.headers={"content-type":"application/json"}),(await Mn(e,i)).json()}async function Wf(n,e){let t=e?window.open("","_blank"):null;t&&(t.opener=null);try{let{ticket:i}=zr.get()===null?{ticket:null}:await Vn("POST","v1/tickets",{path:`/${n}`}),s=vc(`${n}${Si({ticket:i})}`).href;t?t.location.href=s:location.assign(s)}catch(i){throw t?.close(),i}}async function bc(n,e){Ha(await(await Mn(n)).blob(),e)}function Ha(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function Si(n){let e=Object.entries(n).filter(([,i])=>i!=null&&i!==""),t=new URLSearchParams(e.map(([i,s])=>[i,String(s)])).toString();return t===""?"":`?${t}`}var Et=n=>{if(n instanceof zn){let e=n.problem.errors?.map(t=>`${t.pointer}: ${t.detail}`).join("; ");return[n.problem.title,n.problem.detail,e].filter(Boolean).join(": ")}return n instanceof TypeError?"The service cannot be reached.":String(n)};function _e(n,e=3){return n==null||!Number.isFinite(n)?"–":Number.isInteger(n)?n.toLocaleString("en"):n.toLocaleString("en",{maximumSignificantDigits:e})}var Mi=n=>n==null?"–":`${n.toFixed(2)} mm`,Po=n=>`${(100*n).toFixed(n>.995||n<.1?1:0)} %`;function Bi(n){if(n<1e3)return`${Math.round(n)} ms`;let e=n/1e3;return e<60?`${e.toFixed(1)} s`:e<3600?`${Math.floor(e/60)} min ${Math.round(e%60)} s`:e<86400?`${Math.floor(e/3600)} h ${Math.round(e%3600/60)} min`:`${Math.floor(e/86400)} d ${Math.round(e%86400/3600)} h`}var _s=(n,e)=>{let t=e-Date.parse(n);return t<1e3?"now":Bi(Math.floor(t/1e3)*1e3).replace(".0 s"," s")},Io=n=>n<1024?`${n} B`:n<1<<20?`${(n/1024).toFixed(1)} KiB`:n<1<<30?`${(n/(1<<20)).toFixed(1)} MiB`:`${(n/(1<<30)).toFixed(1)} GiB`,It=n=>n.replaceAll("_"," "),Kn=n=>n!=="queued"&&n!=="running",Qn=n=>n.slice(-8),oS={unlike_shape:{meaning:"One surface is drawn out far to become the other, compared with how well curvatures of corresponding points agree.",check:"Do both files show the same structure? Is a part of one missing?"},other_handedness:{meaning:"A mirrored source fits better.",check:"Is one file a left structure and the other a right one, or does an image have a flipped axis?"},uncertain_side:{meaning:"A file states two orientations of different handedness: left and right may be exchanged.",check:"Which orientation of the file is right? Write it into both places (sform and qform)."},units_differ:{meaning:"The sizes differ by the ratio of two units of length.",check:"Are both files in millimeters? Scale one of them, or state its unit in the file."},ambiguous_pose:{meaning:"A different pose fits as well.",check:"Is the shape nearly symmetric? Landmarks resolve it: submit again with a few corresponding points."},piece_dropped:{meaning:"A structure is in several pieces, and one that was dropped has 5 % or more of its volume.",check:"Are left and right one label, or several structures? Choose the labels of one, or name the repair largest_component."},labels_joined:{meaning:"Several labels of one input were joined, and the other input has other labels.",check:"Which labels are the structure? Submit again with them."},cavity_filled:{meaning:"A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much.",check:"Is the label a wall around something else? Name the repair fill to confirm that the inside belongs to it."},second_opinion:{meaning:"The default method finds another pose for these surfaces, or other corresponding points.",check:"Which of the two answers is right? Submit again with the method balanced, and look at both."},too_coarse:{meaning:"The voxels are so large for the structure that they leave its rotation uncertain.",check:"Is there a segmentation of smaller voxels? Interpolating this one adds nothing."}};function aS(n){let e=n.parameters?.input;return(n.unreliable_reasons??[]).includes("other_handedness")&&e?.source?.mirror===!1}function Og(n){if(n.state==="succeeded"){if(n.method==="study_score")return{tone:"neutral",mark:"=",title:"Scored against its study",lines:["The subject was matched to the template of the study and compared with its group; both inputs below are the subject."],next:"Look first whether its match is reliable, then at the p of its shape and at the regions beyond the bound."};if(n.reliable===!0){let i=n.surface_distance?`The registered surfaces are ${Mi(n.surface_distance.mean_mm)} apart on average.`:"";return{tone:"good",mark:"✓",title:"Reliable",lines:[`${n.method==="balanced"?"No check found a fault.":"No check found a fault, and the default method finds the same."} ${i}`,...n.warnings??[]],next:"Look for colors that jump in the picture below; if there are none, keep this match."}}if(n.reliable===!1){let i=(n.unreliable_reasons??[]).map(s=>oS[s]??{meaning:It(s),check:""});return{tone:"bad",mark:"✕",title:"Not reliable",lines:[...i.map(s=>s.meaning),...n.warnings??[]],next:[...i.map(s=>s.check),...aS(n)?["If so, submit it again with input.source.mirror: true, which mirrors the source."]:[]].join(" ")}}return{tone:"neutral",mark:"?",title:"Not checked",lines:["No displacement field could be fitted, which the checks are made of.",...n.warnings??[]],next:n.method==="balanced"?"Judge by the picture: where colors jump or the grid breaks, the match is wrong.":"Judge by the picture, or match again with the method balanced, whose answer beside this one is the check."}}let t={queued:{tone:"wait",mark:"…",title:"Waiting",lines:[n.queue_position?`Number ${n.queue_position} in the queue.`:"In the queue."],next:"It starts when a worker is free."},running:{tone:"wait",mark:"…",title:n.cancel_requested?"Being cancelled":"Running",lines:[n.eta_ms?`About ${Bi(n.eta_ms)} left.`:"The verdict comes with the result."],next:"The energy below says what it minimizes at present; whether the match is right, the verdict says at the end."},cancelled:{tone:"neutral",mark:"–",title:"Cancelled",lines:["It has no result."],next:"Submit it again with Retry."},expired:{tone:"bad",mark:"✕",title:"Expired",lines:["It had not started by its deadline."],next:"Submit it again with Retry, or with a later deadline."}}[n.state];return t||{tone:"bad",mark:"✕",title:n.state==="dead"?"Given up":"Failed",lines:[[n.error?.title,n.error?.detail].filter(Boolean).join(": ")||"It has no result."],next:n.state==="dead"?"Its workers crashed too often. Retry once; if it fails again, report it.":"Correct the input, then submit it again."}}function Sc(n){if(n.state!=="succeeded")return{tone:"neutral",text:""};if(n.reliable===!0)return{tone:"good",text:"✓ reliable"};let[e,...t]=n.unreliable_reasons??[];return n.reliable===!1?{tone:"bad",text:`✕ ${It(e??"not reliable")}${t.length>0?` and ${t.length} more`:""}`}:{tone:"neutral",text:"not checked"}}var lS=Symbol.for("pv"),cS=0;function p(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:lS,__v:--cS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),zt.vnode&&zt.vnode(c),c}var hn=({tone:n,children:e})=>p("span",{class:`badge ${n}`,children:e}),uS={queued:"wait",running:"wait",succeeded:"good",failed:"bad",dead:"bad",expired:"bad",cancelled:"neutral"},Lo=({state:n})=>p(hn,{tone:uS[n],children:n}),wi=({share:n,label:e})=>p("progress",{class:"bar",max:1,value:n,"aria-label":e});function At({text:n}){return n===null?null:p("p",{class:"failure",role:"alert",children:n})}function Rn({rows:n}){return p("dl",{class:"facts",children:n.map(([e,t])=>p("div",{children:[p("dt",{children:e}),p("dd",{children:t})]},e))})}function ki(){let[n,e]=ae(Date.now());return ct(()=>{let t=setInterval(()=>e(Date.now()),1e3);return()=>clearInterval(t)},[]),n}function dr(n,e){let[t,i]=ae(localStorage.getItem(`homolog-${n}`)??e);return[t,s=>{i(s),localStorage.setItem(`homolog-${n}`,s)}]}function Vt(n,e){ct(()=>{let t=new AbortController;return n(t.signal),()=>t.abort()},e)}function xs(){let[n,e]=ae(0);return ct(()=>{let t=()=>e(s=>s+1),i=matchMedia("(prefers-color-scheme: dark)");return i.addEventListener("change",t),window.addEventListener("theme",t),()=>{i.removeEventListener("change",t),window.removeEventListener("theme",t)}},[]),n}function Wa({value:n,take:e,...t}){let[i,s]=ae(null);return p("input",{...t,value:i??n,onInput:r=>s(r.currentTarget.value),onChange:r=>{s(null),e(r.currentTarget.value)}})}function qn({label:n,checked:e,onChange:t}){return p("label",{class:"check",children:[p("input",{type:"checkbox",checked:e,onChange:t})," ",n]})}function Ug(){let[n="",e=""]=location.hash.replace(/^#\/?/,"").split("?");return{path:n.split("/").filter(Boolean).map(decodeURIComponent),query:new URLSearchParams(e)}}function Ti(n,e={},t=!1){let i=Object.entries(e).filter(([,o])=>o!==""),s=new URLSearchParams(i).toString(),r=`#/${n}${s===""?"":`?${s}`}`;t?(history.replaceState(null,"",r),window.dispatchEvent(new HashChangeEvent("hashchange"))):location.hash=r}function Bg(){let[n,e]=ae(Ug);return ct(()=>{let t=()=>e(Ug());return window.addEventListener("hashchange",t),()=>window.removeEventListener("hashchange",t)},[]),n}var Mc=["state","method","tag","external_ref","batch","study","order"];function hS(n){try{let e=JSON.parse(n);return(Array.isArray(e)?e.filter(i=>typeof i?.name=="string"&&typeof i.filters=="object"&&i.filters!==null):[]).map(({name:i,filters:{label:s,...r}})=>({name:i,filters:s?{...r,tag:s}:r}))}catch{return[]}}var fS=(n,e)=>Mc.every(t=>(n[t]??"")===(e[t]??""));function kg({filters:n,isFiltered:e}){let[t,i]=dr("filters","[]"),[s,r]=ae(null),o=hS(t),a=o.find(c=>fS(c.filters,n)),l=()=>{let c=(s??"").trim();c!==""&&i(JSON.stringify([...o.filter(u=>u.name!==c),{name:c,filters:n}])),r(null)};return p(mt,{children:[o.length>0&&p("label",{children:["Saved filters"," ",p("select",{value:a?.name??"",onChange:c=>Ti("jobs",o.find(u=>u.name===c.currentTarget.value)?.filters??{},!0),children:[p("option",{value:"",children:"none"}),o.map(c=>p("option",{value:c.name,children:c.name}))]})]}),a?p("button",{type:"button",onClick:()=>i(JSON.stringify(o.filter(c=>c!==a))),children:["Forget “",a.name,"”"]}):e&&(s===null?p("button",{type:"button",onClick:()=>r(""),children:"Save these filters …"}):p("span",{class:"group",children:[p("input",{"aria-label":"Name of these filters",placeholder:"name",value:s,onInput:c=>r(c.currentTarget.value),onKeyDown:c=>{c.key==="Enter"?l():c.key==="Escape"&&r(null)}}),p("button",{type:"button",onClick:l,children:"Save"})]}))]})}function zg(n){return typeof n=="object"?n.key:n}function Vg(n,e){let t=n.length;return new Proxy(n,{get(i,s,r){if(typeof s=="string"){let o=s.charCodeAt(0);if(o>=48&&o<=57){let a=+s;if(Number.isInteger(a)&&a>=0&&a<t){let l=i[a];if(typeof l!="object"){let c=e[a*2];l=i[a]={index:a,key:l,start:c,size:e[a*2+1],end:c+e[a*2+1],lane:0}}return l}}if(s==="length")return t}return Reflect.get(i,s,r)}})}function Vr(n,e,t){let i=t.initialDeps??[],s,r=!0;function o(){var a;let c=0,u=n();if(!(u.length!==i.length||u.some((d,y)=>i[y]!==d)))return s;i=u;let f=0;return s=e(...u),t?.onChange&&!(r&&t.skipInitialOnChange)&&t.onChange(s),r=!1,s}return o.updateDeps=a=>{i=a},o}function $f(n,e){if(n===void 0)throw new Error(`Unexpected undefined${e?`: ${e}`:""}`);return n}var Fs=(n,e)=>Math.abs(n-e)<1.01,Gg=(n,e,t)=>{let i;return Object.assign(function(...s){n.clearTimeout(i),i=n.setTimeout(()=>e.apply(this,s),t)},{cancel:()=>{n.clearTimeout(i)}})};function Hg({offset:n,isScrolling:e,elementMax:t,holdOffset:i,scrollOffset:s,pendingWrite:r,clampedMaxAtWrite:o}){var a;return e&&r===null&&n===s?"spurious":r!==null&&Math.abs(n-r.target)<1.5?"readBack":r!==null&&!r.smooth&&t!==null&&r.target>t+i+.5&&Math.abs(n-(t+i))<1.5||r!==null&&!r.smooth&&((a=r.lowMaxes)!=null&&a.some(l=>Math.abs(n-l)<1.5))?"clampedReadBack":o!==null&&Math.abs(n-o)<1.5?"clampedEcho":"external"}var dS=n=>n==="smooth"||n==="smoothFinishing";function Wg({kind:n,offset:e,command:t,target:i}){return n!=="spurious"&&n!=="readBack"&&n!=="clampedReadBack"&&t?.index!=null&&t.phase!=="queued"&&!dS(t.phase)&&!Fs(e,t.lastTargetOffset)&&!Fs(e,i())&&n!=="clampedEcho"}var Xf=40;function $g(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Xf;)t--;if(t<0)return!1;let i=n[t],s=t-1;for(;s>=0&&i.t-n[s].t<Xf;)s--;if(s<0)return!1;let r=n[s],o=(e.offset-i.offset)/(e.t-i.t),a=(i.offset-r.offset)/(i.t-r.t);return o*a>=0&&Math.abs(o)>=2*Math.abs(a)&&Math.abs(o)-Math.abs(a)>=.8}function Xg(n){let e=n[n.length-1];if(e===void 0)return!1;let t=n.length-2;for(;t>=0&&e.t-n[t].t<Xf;)t--;if(t<0)return!1;let i=n[t];return Math.abs(e.offset-i.offset)/(e.t-i.t)>=.05}var $a,Xa=()=>{if($a!==void 0)return $a;if(typeof navigator>"u")return $a=!1;if(/iP(hone|od|ad)/.test(navigator.userAgent))return $a=!0;let n=navigator.maxTouchPoints;return $a=navigator.platform==="MacIntel"&&n!==void 0&&n>0},qf,pS=()=>qf!==void 0?qf:qf=Xa()&&typeof CSS<"u"&&typeof CSS.supports=="function"&&CSS.supports("overflow-anchor: auto"),qg=()=>!Xa()||pS();var No={capture:!0,passive:!0},wc=class{constructor(e){this.host=e,this._touch=null,this.inMotion=()=>this._touch!==null&&this._touch.phase!=="lateFling",this.dragging=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved},this.tail=()=>{var t;return((t=this._touch)==null?void 0:t.phase)==="tail"?this._touch.moved?"fling":"tap":null},this.onScroll=({isScrolling:t,ownReadBack:i,moved:s,external:r})=>{var o,a,l;return t&&((o=this._touch)==null?void 0:o.phase)==="tail"?this._openTail(this._touch.moved||!i,!1):((a=this._touch)==null?void 0:a.phase)==="lateFling"&&(this.host.now()>this._touch.until?this._touch=null:r&&t&&s&&this._openTail(!0,!1)),!i&&t&&s&&((l=this._touch)==null?void 0:l.phase)==="down"?(this._touch.moved=!0,!0):!1},this.touchStart=()=>{this.end(),this._touch={phase:"down",moved:!1}},this.touchEnd=()=>{var t;let i=((t=this._touch)==null?void 0:t.phase)==="down"&&this._touch.moved;this.end(),this._openTail(i,i)},this.end=()=>{var t;let i=this.host.getWindow();((t=this._touch)==null?void 0:t.phase)==="tail"&&i!=null&&i.clearTimeout(this._touch.timerId),this._touch=null},this.listen=t=>{let i=()=>this.touchStart(),s=()=>this.touchEnd();return t.addEventListener("touchstart",i,No),t.addEventListener("touchend",s,No),t.addEventListener("touchcancel",s,No),()=>{t.removeEventListener("touchstart",i,No),t.removeEventListener("touchend",s,No),t.removeEventListener("touchcancel",s,No),this.end()}},this._openTail=(t,i)=>{let s=this.host.getWindow();if(s==null)return;this.end();let r={phase:"tail",moved:t,awaitingFling:i,timerId:s.setTimeout(()=>{if(this.host.tailStillMoving()){this._openTail(r.moved,r.awaitingFling);return}this._touch=r.awaitingFling?{phase:"lateFling",until:this.host.now()+1e3}:null,this.host.onTailClosed()},150)};this._touch=r}}get touch(){return this._touch}};var Yg=n=>{let{clientWidth:e,clientHeight:t}=n;return{width:e,height:t}},Zg=n=>{let e=new Set;return{schedule:t=>{let i=n.requestAnimationFrame(()=>{e.delete(i),t()});e.add(i)},cancel:()=>{e.forEach(t=>n.cancelAnimationFrame(t)),e.clear()}}},mS=n=>n,gS=n=>{let e=n.overscan*Math.max(n.lanes??1,1),t=Math.max(n.startIndex-e,0),s=Math.min(n.endIndex+e,n.count-1)-t+1,r=new Array(s);for(let o=0;o<s;o++)r[o]=t+o;return r},Kg=(n,e)=>{let t=n.scrollElement;if(!t)return;let i=n.targetWindow;if(!i)return;let s=a=>{let{width:l,height:c}=a;e({width:Math.round(l),height:Math.round(c)})};if(s(Yg(t)),!i.ResizeObserver)return()=>{};let r=Zg(i),o=new i.ResizeObserver(()=>{let a=()=>{s(Yg(t))};n.options.useAnimationFrameWithResizeObserver?r.schedule(a):a()});return o.observe(t,{box:"content-box"}),()=>{o.unobserve(t),r.cancel()}},jg={passive:!0};var _S=typeof window>"u"?!0:"onscrollend"in window,xS=(n,e,t)=>{let i=n.scrollElement;if(!i)return;let s=n.targetWindow;if(!s)return;let r=n.options.useScrollendEvent&&_S,o=0,a=r?null:Gg(s,()=>e(t(i),!1),n.options.isScrollingResetDelay),l=h=>()=>{o=t(i),a?.(),e(o,h)},c=l(!0),u=l(!1);return i.addEventListener("scroll",c,jg),r&&i.addEventListener("scrollend",u,jg),()=>{i.removeEventListener("scroll",c),r&&i.removeEventListener("scrollend",u),a?.cancel()}},Qg=(n,e)=>xS(n,e,t=>{let{horizontal:i,isRtl:s}=n.options;return i?t.scrollLeft*(s&&-1||1):t.scrollTop});var yS=(n,e,t)=>{if(t.options.useCachedMeasurements){let i=t.indexFromElement(n),s=t.options.getItemKey(i);return t.itemSizeCache.get(s)??t.options.estimateSize(i)}if(e?.borderBoxSize){let i=e.borderBoxSize[0];if(i)return Math.round(i[t.options.horizontal?"inlineSize":"blockSize"])}if(!e){let i=t.indexFromElement(n),s=t.options.getItemKey(i),r=t.itemSizeCache.get(s);if(r!==void 0)return r}return n[t.options.horizontal?"offsetWidth":"offsetHeight"]},vS=(n,{adjustments:e=0,behavior:t},i)=>{var s;let{scrollElement:r,options:o}=i,a=n+e,l=o.horizontal&&o.isRtl&&r!==null&&"ownerDocument"in r;(s=r?.scrollTo)==null||s.call(r,{[o.horizontal?"left":"top"]:l?-a:a,behavior:t})};var e0=vS,Jg=(n,e)=>n==="smooth"?e?"smoothLanded":"smooth":"instant",qa=n=>n?.phase==="smooth"||n?.phase==="smoothLanded";function bS(n,e,t,i){if(e===0)return!1;let s=i(0),r=new Set,o=0;for(;o<n;){let l=t(o);if(l===s)break;r.add(l),o++}let a=n-o;if(a===0||a>=e)return!1;for(let l=0;l<a;l++)if(i(l)!==t(o+l))return!1;for(let l=a;l<e;l++)if(r.has(i(l)))return!1;return!0}var Tc=class{constructor(e){this.unsubs=[],this.scrollElement=null,this.targetWindow=null,this.isScrolling=!1,this.scrollState=null,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache=new Map,this.itemSizeCacheVersion=0,this.laneAssignments=new Map,this.pendingMin=null,this.prevLanes=void 0,this.lanesChangedFlag=!1,this.lanesSettling=!1,this.pendingScrollAnchor=null,this.scrollRect=null,this.scrollOffset=null,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._iosGesture=new wc({getWindow:()=>this.targetWindow,now:()=>this.now(),tailStillMoving:()=>{let t=this.scrollState;if(t?.phase!=="queued"||this.pendingWrite!==null)return!1;let i=this._readElementOffset();return i===null||this._lastElementOffset===null||Math.abs(i-this._lastElementOffset)<1?!1:(this._lastElementOffset=i,t.samples=[...t.samples??[],{t:this.now(),offset:i}],!0)},onTailClosed:()=>{let t=this.scrollState;t?.phase==="queued"&&Xg(t.samples??[])&&(this.scrollState=null),this._flushHoldIfReady(!0),this._writeAwaitingCommand(),this._retryClampedAdjustment()}}),this._lastElementOffset=null,this.pendingWrite=null,this._clampedAdjustment=null,this.elementsCache=new Map,this._resizeBatch=null,this.now=()=>{var t,i,s;return((s=(i=(t=this.targetWindow)==null?void 0:t.performance)==null?void 0:i.now)==null?void 0:s.call(i))??Date.now()},this.observer=(()=>{let t=null,i=null,s=!1,r=!1,o=new Set,a=()=>{if(t)return t;let c=this.targetWindow;if(!c||!c.ResizeObserver)return null;let u=i=Zg(c);return t=new c.ResizeObserver(h=>{let f=()=>{let d={sync:!1};this._resizeBatch=d;try{h.forEach(l)}finally{this._resizeBatch=null,d.notify&&(this.notify(d.sync),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment(),this.measureElement(null))}};if(this.options.useAnimationFrameWithResizeObserver)u.schedule(f);else{s=!0;try{f()}finally{s=!1}}})},l=c=>{let u=c.target,h=this.indexFromElement(u);if(!u.isConnected){this.observer.unobserve(u);for(let[f,d]of this.elementsCache)if(d===u){this.elementsCache.delete(f);break}return}this.isIndexInRange(h)&&this.shouldMeasureDuringScroll(h)&&this.resizeItem(h,this.options.measureElement(u,c,this))};return{disconnect:()=>{var c;(c=a())==null||c.disconnect(),i?.cancel(),o.clear(),r=!1,t=null,i=null},observe:c=>{let u=a();if(u){if(!s){u.observe(c,{box:"border-box"});return}o.add(c),r||(r=!0,i?.schedule(()=>{r=!1,o.forEach(h=>{h.isConnected&&t?.observe(h,{box:"border-box"})}),o.clear()}))}},unobserve:c=>{var u;o.delete(c),(u=a())==null||u.unobserve(c)}}})(),this.range=null,this.setOptions=t=>{var i;let s={debug:!1,initialOffset:0,overscan:1,paddingStart:0,paddingEnd:0,scrollPaddingStart:0,scrollPaddingEnd:0,horizontal:!1,getItemKey:mS,rangeExtractor:gS,onChange:()=>{},measureElement:yS,initialRect:{width:0,height:0},scrollMargin:0,gap:0,indexAttribute:"data-index",initialMeasurementsCache:[],lanes:1,anchorTo:"start",followOnAppend:!1,scrollEndThreshold:1,isScrollingResetDelay:150,enabled:!0,isRtl:!1,useScrollendEvent:!1,useAnimationFrameWithResizeObserver:!1,laneAssignmentMode:"estimate",useCachedMeasurements:!1};for(let u in t){let h=t[u];h!==void 0&&(s[u]=h)}let r=this.options,o=null,a=null,l=!1;if(r!==void 0&&r.enabled&&s.enabled&&s.anchorTo==="end"&&this.scrollElement!==null){let u=r.count,h=s.count,f=this.getMeasurements(),d=((i=this._singleLaneMeasurements)==null?void 0:i.items)??f,y=M=>zg(d[M]),v=u>0?y(0):null,g=u>0?y(u-1):null;if(h!==u||u>0&&h>0&&(s.getItemKey(0)!==v||s.getItemKey(h-1)!==g)){l=!0;let M=u>0?this.getVirtualItemForOffset(this.getScrollOffset())??f[0]:null;M&&(o=[M.key,this.getScrollOffset()-M.start]);let S=s.followOnAppend===!0?"auto":s.followOnAppend||null;S&&h>0&&this.isAtEnd(r.scrollEndThreshold)&&(u===0||s.getItemKey(h-1)!==g)&&(h>u||bS(u,h,y,s.getItemKey))&&(a=S)}}this.options=s,l&&(this.pendingMin=0,this.itemSizeCacheVersion++);let c=null;if(o&&this.scrollOffset!==null&&!this._awaitingCommandReadBack()){let[u,h]=o,f=this.getMeasurements(),{count:d,getItemKey:y}=this.options,v=0;for(;v<d&&y(v)!==u;)v++;if(v<d){let g=f[v];if(g){let x=Math.max(0,g.start+h);!a&&x!==this.scrollOffset&&(c=x-this.scrollOffset,this.scrollOffset=x)}}}a?this.pendingScrollAnchor={kind:"follow",behavior:a}:c!==null&&(this._canWriteScroll()?this.pendingScrollAnchor={kind:"anchor",delta:c}:(this._holdOffset+=c,this._followOffsetTarget(c)))},this.notify=t=>{var i,s;(s=(i=this.options).onChange)==null||s.call(i,this,t)},this.maybeNotify=Vr(()=>(this.calculateRange(),[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]),t=>{this.notify(t)},{key:!1,debug:()=>this.options.debug,initialDeps:[this.isScrolling,this.range?this.range.startIndex:null,this.range?this.range.endIndex:null]}),this.cleanup=()=>{var t;this.unsubs.filter(Boolean).forEach(i=>i()),this.unsubs=[],this.observer.disconnect(),this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null,(t=this._momentumStop)==null||t.restore(),this._momentumStop=null,this.isScrolling=!1,this.scrollDirection=null,this._holdOffset=0,this._reportedOverscroll=!1,this._clampedAdjustment=null,this.pendingWrite=null,this.scrollElement=null,this.targetWindow=null},this._didMount=()=>()=>{this.cleanup()},this._willUpdate=()=>{var t;let i=this.options.enabled?this.options.getScrollElement():null;if(this.scrollElement!==i){if(this.cleanup(),!i){this.maybeNotify();return}this.scrollElement=i,this.scrollElement&&"ownerDocument"in this.scrollElement?this.targetWindow=this.scrollElement.ownerDocument.defaultView:this.targetWindow=((t=this.scrollElement)==null?void 0:t.window)??null,this.elementsCache.forEach(r=>{this.observer.observe(r)}),this.unsubs.push(this.options.observeElementRect(this,r=>{this.scrollRect=r,this.maybeNotify()})),this.unsubs.push(this.options.observeElementOffset(this,(r,o)=>{var a,l,c,u;let h=o?this._elementMaxScrollOffset():null,f=this._reportedOverscroll;this._reportedOverscroll=r<0||h!==null&&r>h+1;let d=r;this._lastElementOffset=d,r=this._toLayoutOffset(r);let y=this._classifyScrollEvent(r,o,h);if(y==="spurious")return;y==="readBack"?r=this.pendingWrite.target:y==="clampedReadBack"&&((a=this.scrollState)==null?void 0:a.index)!=null&&r<this.getMaxScrollOffset()-1.5?this.scrollState.lastTargetOffset=r:Wg({kind:y,offset:r,command:this.scrollState,target:()=>this.getScrollStateTarget(this.scrollState)})&&(this.scrollState=null),this.pendingWrite=null,this._clampedAdjustment!==null&&Math.abs(r-this._clampedAdjustment.maxAtWrite)>=1.5&&(this._clampedAdjustment=null);let v=this.getScrollOffset(),g=this.scrollDirection;this.scrollDirection=o?v===r?this.scrollDirection:v<r?"forward":"backward":null,this.scrollOffset=r,this.isScrolling=o;let x=this.scrollState;if(x?.phase==="queued"&&y==="external"&&o)if(f||this._reportedOverscroll)x.samples=[];else{let _=this.now();x.samples=[...(x.samples??[]).filter(M=>_-M.t<=200),{t:_,offset:d}],(g!==null&&this.scrollDirection!==g||$g(x.samples))&&(this.scrollState=null)}this._iosGesture.onScroll({isScrolling:o,ownReadBack:y==="readBack",moved:r!==v,external:y==="external"&&((l=this.scrollState)==null?void 0:l.phase)!=="smooth"&&((c=this.scrollState)==null?void 0:c.phase)!=="smoothFinishing"})&&((u=this.scrollState)==null?void 0:u.phase)==="queued"&&(this.scrollState=null),this._flushHoldIfReady(!0),this.scrollState&&this.scheduleScrollReconcile(),this.maybeNotify()})),"addEventListener"in this.scrollElement&&this.unsubs.push(this._iosGesture.listen(this.scrollElement)),this._scrollToOffset(this.getScrollOffset())}this._noteClampMax();let s=this.pendingScrollAnchor;this.pendingScrollAnchor=null,s&&this.scrollElement&&this.options.enabled&&(s.kind==="anchor"?this._canWriteScroll()?qa(this.scrollState)&&!Fs(this.getScrollOffset()-s.delta,this.scrollState.lastTargetOffset)||(this._followOffsetTarget(s.delta),this._scrollToOffset(this.getScrollOffset())):(this._holdOffset+=s.delta,this._followOffsetTarget(s.delta),this.notify(!1)):this.scrollToEnd({behavior:s.behavior})),this._flushHoldIfReady(!1),this._retryClampedAdjustment()},this._classifyScrollEvent=(t,i,s)=>{var r;return Hg({offset:t,isScrolling:i,elementMax:s,holdOffset:this._holdOffset,scrollOffset:this.scrollOffset,pendingWrite:this.pendingWrite,clampedMaxAtWrite:((r=this._clampedAdjustment)==null?void 0:r.maxAtWrite)??null})},this._retryClampedAdjustment=()=>{if(this._clampedAdjustment===null||!this.scrollElement||!this.options.enabled||!this._canWriteScroll())return;let{target:t,maxAtWrite:i}=this._clampedAdjustment,s=this.getMaxScrollOffset();s>i+.5&&(this._clampedAdjustment=t>s+.5?{target:t,maxAtWrite:s}:null,this._scrollToOffset(t))},this._writeAwaitingCommand=()=>{let t=this.scrollState;if(t===null||t.phase!=="queued")return;let{behavior:i}=t;this.getMeasurements();let s=this.getScrollStateTarget(t);t.lastTargetOffset=s,this._clampedAdjustment=null,t.phase=Jg(i,t.index!=null&&Fs(s,this.getScrollOffset())),this._scrollToOffset(s,{behavior:i}),this.scheduleScrollReconcile()},this._readElementOffset=()=>{let t=this.scrollElement;if(t==null)return null;let{horizontal:i,isRtl:s}=this.options;return typeof t.scrollTop=="number"?i?t.scrollLeft*(s&&-1||1):t.scrollTop:typeof t.scrollY=="number"?i?t.scrollX:t.scrollY:null},this._canWriteScroll=()=>!(Xa()&&this._iosGesture.inMotion())&&!this._reportedOverscroll,this._flushHoldIfReady=t=>{var i;if(this._holdOffset===0||!this.scrollElement||!this.options.enabled||!this._canWriteScroll()||((i=this.scrollState)==null?void 0:i.phase)==="smooth")return;this._holdOffset=0,this.scrollOffset!==null&&this.scrollOffset<0&&(this.scrollOffset=0),this.notify(t);let s=this.getCommandWrittenOffset()??this.getScrollOffset();this._clampedAdjustment=this._clampedBy(s),this._scrollToOffset(s)},this.rafId=null,this.getSize=()=>this.options.enabled?(this.scrollRect=this.scrollRect??this.options.initialRect,this.scrollRect[this.options.horizontal?"width":"height"]):(this.scrollRect=null,0),this.getScrollOffset=()=>this.options.enabled?(this.scrollOffset=this.scrollOffset??(typeof this.options.initialOffset=="function"?this.options.initialOffset():this.options.initialOffset),this.scrollOffset):(this.scrollOffset=null,0),this.getMeasurementOptions=Vr(()=>[this.options.count,this.options.paddingStart,this.options.scrollMargin,this.options.getItemKey,this.options.enabled,this.options.lanes,this.options.laneAssignmentMode,this.options.gap],(t,i,s,r,o,a,l,c)=>(this.prevLanes!==void 0&&this.prevLanes!==a&&(this.lanesChangedFlag=!0),this.prevLanes=a,this.pendingMin=null,{count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c}),{key:!1}),this.isIndexInRange=t=>t>=0&&t<this.options.count,this.getMeasurements=Vr(()=>[this.getMeasurementOptions(),this.itemSizeCacheVersion],({count:t,paddingStart:i,scrollMargin:s,getItemKey:r,enabled:o,lanes:a,laneAssignmentMode:l,gap:c},u)=>{var h;let f=this.itemSizeCache;if(!o)return this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),[];if(this.laneAssignments.size>t)for(let _ of this.laneAssignments.keys())_>=t&&this.laneAssignments.delete(_);this.lanesChangedFlag&&(this.lanesChangedFlag=!1,this.lanesSettling=!0,this.measurementsCache=[],this._singleLaneMeasurements=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.pendingMin=null),this.measurementsCache.length===0&&!this.lanesSettling&&(this.measurementsCache=this.options.initialMeasurementsCache,this.measurementsCache.forEach(_=>{this.itemSizeCache.set(_.key,_.size)}));let d=this.lanesSettling?0:this.pendingMin??0;if(this.pendingMin=null,this.lanesSettling&&this.measurementsCache.length===t&&(this.lanesSettling=!1),a===1){let _=t*2,M=(h=this._singleLaneMeasurements)==null?void 0:h.flat;if(!M||M.length<_){let m=new Float64Array(_);M&&d>0&&m.set(M.subarray(0,d*2)),M=m}let S=d===0?new Array(t):this._singleLaneMeasurements.items.slice(),T;if(d===0)T=i+s;else{let m=d-1;T=M[m*2]+M[m*2+1]+c}for(let m=d;m<t;m++){let w=r(m);S[m]=w;let R=f.get(w),C=typeof R=="number"?R:this.options.estimateSize(m);M[m*2]=T,M[m*2+1]=C,T+=C+c}this._singleLaneMeasurements={flat:M,items:S};let b=Vg(S,M);return this.measurementsCache=b,b}let y=this.measurementsCache.slice(0,d),v=new Array(a).fill(void 0),g=new Float64Array(a),x=0;for(let _=0;_<d;_++){let M=y[_];M&&(v[M.lane]===void 0&&x++,v[M.lane]=_,g[M.lane]=M.end)}for(let _=d;_<t;_++){let M=r(_),S=this.laneAssignments.get(_),T,b,m=l==="estimate"||f.has(M);if(S!==void 0&&this.options.lanes>1){T=S;let I=v[T],E=I!==void 0?y[I]:void 0;b=E?E.end+c:i+s}else if(x===a){let I=0,E=g[0],F=v[0];for(let D=1;D<a;D++){let z=g[D];(z<E||z===E&&v[D]<F)&&(I=D,E=z,F=v[D])}T=I,b=E+c,m&&this.laneAssignments.set(_,T)}else T=_%this.options.lanes,b=i+s,m&&this.laneAssignments.set(_,T);let w=f.get(M),R=typeof w=="number"?w:this.options.estimateSize(_),C=b+R;y[_]={index:_,start:b,size:R,end:C,key:M,lane:T},v[T]===void 0&&x++,v[T]=_,g[T]=C}return this.measurementsCache=y,y},{key:!1,debug:()=>this.options.debug}),this.calculateRange=Vr(()=>[this.getMeasurements(),this.getSize(),this.getScrollOffset(),this.options.lanes,this._getLayoutTotalSize()+this.options.scrollMargin],(t,i,s,r,o)=>{if(t.length===0||i===0)return this.range=null,null;let a=Math.max(o-i,0);return this.range=MS(t,i,Math.min(s,a),r,r===1&&this._singleLaneMeasurements!==null?this._singleLaneMeasurements.flat:null),this.range},{key:!1,debug:()=>this.options.debug}),this.getVirtualIndexes=Vr(()=>{let t=null,i=null,s=this.calculateRange();return s&&(t=s.startIndex,i=s.endIndex),this.maybeNotify.updateDeps([this.isScrolling,t,i]),[this.options.rangeExtractor,this.options.overscan,this.options.count,t,i,this.options.lanes]},(t,i,s,r,o,a)=>r===null||o===null?[]:t({startIndex:r,endIndex:o,overscan:i,count:s,lanes:a}),{key:!1,debug:()=>this.options.debug}),this.indexFromElement=t=>{let i=this.options.indexAttribute,s=t.getAttribute(i);return s?parseInt(s,10):(console.warn(`Missing attribute name '${i}={index}' on measured element.`),-1)},this.shouldMeasureDuringScroll=t=>{var i;if(!qa(this.scrollState))return!0;let s=this.scrollState.index??((i=this.getVirtualItemForOffset(this.scrollState.lastTargetOffset))==null?void 0:i.index);if(s!==void 0&&this.range){let r=Math.max(this.options.overscan,Math.ceil((this.range.endIndex-this.range.startIndex)/2)),o=Math.max(0,s-r),a=Math.min(this.options.count-1,s+r);return t>=o&&t<=a}return!0},this.measureElement=t=>{if(!t){this.elementsCache.forEach((o,a)=>{o.isConnected||(this.observer.unobserve(o),this.elementsCache.delete(a))});return}let i=this.indexFromElement(t);if(!this.isIndexInRange(i))return;let s=this.options.getItemKey(i),r=this.elementsCache.get(s);r!==t&&(r&&this.observer.unobserve(r),this.observer.observe(t),this.elementsCache.set(s,t)),t.isConnected&&(!this.isScrolling||this.scrollState)&&this.shouldMeasureDuringScroll(i)&&this.resizeItem(i,this.options.measureElement(t,void 0,this))},this.resizeItem=(t,i)=>{var s,r,o;if(!this.isIndexInRange(t))return;(s=this._resizeBatch)!=null&&s.sync&&this.getMeasurements();let a,l,c,u=(r=this._singleLaneMeasurements)==null?void 0:r.flat;if(this.options.lanes===1&&u!=null)c=this.options.getItemKey(t),l=u[t*2],a=u[t*2+1];else{let d=this.measurementsCache[t];if(!d)return;c=d.key,l=d.start,a=d.size}let h=this.itemSizeCache.get(c)??a,f=i-h;if(f!==0){let d=this.options.anchorTo==="end"&&!qa(this.scrollState)&&this.getVirtualDistanceFromEnd()<=this.options.scrollEndThreshold,y=d?this._getLayoutTotalSize():0,v=this.getScrollOffset(),x=!this.itemSizeCache.has(c)?l<v:l+h<=v&&this.scrollDirection!=="backward",_=!qa(this.scrollState)&&(this.shouldAdjustScrollPositionOnItemSizeChange!==void 0?this.shouldAdjustScrollPositionOnItemSizeChange(this.measurementsCache[t]??{index:t,key:c,start:l,size:a,end:l+a,lane:0},f,this):x);(this.pendingMin===null||t<this.pendingMin)&&(this.pendingMin=t),this.itemSizeCache.set(c,i),this.itemSizeCacheVersion++;let M=!1;if(this._awaitingCommandReadBack()||(d?M=this.applyScrollAdjustment(this._getLayoutTotalSize()-y):_&&(M=this.applyScrollAdjustment(f))),this._resizeBatch){this._resizeBatch.notify=!0,(o=this._resizeBatch).sync||(o.sync=M);return}this.notify(M),this._noteClampMax(),this._flushHoldIfReady(!0),this._retryClampedAdjustment()}},this.getVirtualItems=Vr(()=>[this.getVirtualIndexes(),this.getMeasurements(),this._holdOffset],(t,i,s)=>{let r=[];for(let o=0,a=t.length;o<a;o++){let l=t[o],c=i[l];r.push(s===0?c:{...c,start:c.start-s,end:c.end-s})}return r},{key:!1,debug:()=>this.options.debug}),this.getVirtualItemForOffset=t=>{var i;let s=this.getMeasurements();if(s.length===0)return;let r=(i=this._singleLaneMeasurements)==null?void 0:i.flat,o=this.options.lanes===1&&r!=null,a=t0(0,s.length-1,o?l=>r[l*2]:l=>$f(s[l]).start,t);return $f(s[a])},this._noteClampMax=()=>{if(!this._awaitingCommandReadBack())return;let t=this._elementMaxScrollOffset();if(t===null)return;let i=this.pendingWrite,s=Math.max(t,0)+this._holdOffset;if(s>=i.target)return;let r=i.lowMaxes??(i.lowMaxes=[]);r[r.length-1]!==s&&r.push(s)},this.getMaxScrollOffset=()=>(this._elementMaxScrollOffset()??0)+this._holdOffset,this._toLayoutOffset=t=>{var i;let s=t+this._holdOffset;return((i=this.pendingScrollAnchor)==null?void 0:i.kind)==="anchor"&&(s+=this.pendingScrollAnchor.delta),s},this._elementMaxScrollOffset=()=>{let t=this.scrollElement;if(t===null)return null;if("scrollHeight"in t)return this.options.horizontal?t.scrollWidth-t.clientWidth:t.scrollHeight-t.clientHeight;if("document"in t){let i=t.document.documentElement;return this.options.horizontal?i.scrollWidth-t.innerWidth:i.scrollHeight-t.innerHeight}return null},this._momentumStop=null,this._stopMomentum=t=>{let i=this.scrollElement,s=this.targetWindow;if(i===null||s===null)return;let r="document"in i?i.document.scrollingElement:i;if(!r?.style)return;if(this._momentumStop){this._momentumStop.done=t;return}let{style:o}=r,a=this.options.horizontal?"overflow-x":"overflow-y",l=o.getPropertyValue(a),c=o.getPropertyPriority(a),u=()=>this.options.horizontal?r.clientHeight:r.clientWidth,h=u();if(o.setProperty(a,"hidden","important"),u()!==h){o.setProperty(a,l,c);return}let f={restore:()=>o.getPropertyValue(a)!=="hidden"||o.getPropertyPriority(a)!=="important"?!1:(o.setProperty(a,l,c),!0),done:t};this._momentumStop=f,s.requestAnimationFrame(()=>s.requestAnimationFrame(()=>{this._momentumStop===f&&(this._momentumStop=null,f.restore()&&f.done())}))},this._clampedBy=t=>{let i=this._elementMaxScrollOffset();if(i===null)return null;let s=i+this._holdOffset;return t>s+.5?{target:t,maxAtWrite:s}:null},this.getVirtualDistanceFromEnd=()=>Math.max(this._getLayoutTotalSize()+this.options.scrollMargin-this.getSize()-this.getScrollOffset(),0),this.getDistanceFromEnd=()=>Math.max(this.getMaxScrollOffset()-this.getScrollOffset(),0),this.isAtEnd=(t=this.options.scrollEndThreshold)=>this.getDistanceFromEnd()<=t,this.getOffsetForAlignment=(t,i,s=0)=>{if(!this.scrollElement)return 0;let r=this.getSize(),o=this.getScrollOffset();i==="auto"&&(i=t>=o+r?"end":"start"),i==="center"?t+=(s-r)/2:i==="end"&&(t-=r);let a=this.getMaxScrollOffset();return Math.max(Math.min(a,t),0)},this.getOffsetForIndex=(t,i="auto")=>{t=Math.max(0,Math.min(t,this.options.count-1));let s=this.getSize(),r=this.getScrollOffset(),o=this.getMeasurements()[t];if(!o)return;if(i==="auto")if(o.end>=r+s-this.options.scrollPaddingEnd)i="end";else if(o.start<=r+this.options.scrollPaddingStart)i="start";else return[r,i];if(i==="end"&&t===this.options.count-1){let l=this.getMaxScrollOffset(),c=l-this.options.paddingEnd+this.options.scrollPaddingEnd;return[Math.max(Math.min(c,l),0),i]}let a=i==="end"?o.end+this.options.scrollPaddingEnd:o.start-this.options.scrollPaddingStart;return[this.getOffsetForAlignment(a,i,o.size),i]},this.scrollToOffset=(t,{align:i="start",behavior:s="auto"}={})=>{this._startScroll({index:null,align:i},this.getOffsetForAlignment(t,i),s,"absolute")},this.scrollToIndex=(t,{align:i="auto",behavior:s="auto"}={})=>{t=Math.max(0,Math.min(t,this.options.count-1));let r=this.getOffsetForIndex(t,i);if(!r)return;let[o,a]=r;this._startScroll({index:t,align:a},o,s,"absolute")},this.scrollBy=(t,{behavior:i="auto"}={})=>{let s=this.getOffsetForAlignment((this.getCommandWrittenOffset()??this.getScrollOffset())+t,"start");this._startScroll({index:null,align:"start"},s,i,"relative")},this.scrollToEnd=({behavior:t="auto"}={})=>{if(this.options.count>0){this._startScroll({index:this.options.count-1,align:"end",toEnd:!0},Math.max(this.getMaxScrollOffset(),0),t,"absolute");return}this.scrollToOffset(Math.max(this.getTotalSize()-this.getSize(),0),{behavior:t})},this.cancelScroll=()=>{this.rafId!=null&&this.targetWindow&&(this.targetWindow.cancelAnimationFrame(this.rafId),this.rafId=null),this.scrollState=null},this.getTotalSize=()=>Math.max(this._getLayoutTotalSize()-this._holdOffset,0),this._getLayoutTotalSize=()=>{var t,i;let s=this.getMeasurements(),r;if(s.length===0)r=this.options.paddingStart;else if(this.options.lanes===1){let o=s.length-1,a=(t=this._singleLaneMeasurements)==null?void 0:t.flat;a!=null?r=a[o*2]+a[o*2+1]:r=((i=s[o])==null?void 0:i.end)??0}else{let o=Array(this.options.lanes).fill(null),a=s.length-1;for(;a>=0&&o.some(l=>l===null);){let l=s[a];o[l.lane]===null&&(o[l.lane]=l.end),a--}r=Math.max(...o.filter(l=>l!==null))}return Math.max(r-this.options.scrollMargin+this.options.paddingEnd,0)},this.takeSnapshot=()=>{let t=[];if(this.itemSizeCache.size===0)return t;let i=this.getMeasurements();for(let s of i)s&&this.itemSizeCache.has(s.key)&&t.push({index:s.index,key:s.key,start:s.start,size:s.size,end:s.end,lane:s.lane});return t},this._scrollToOffset=(t,{adjustments:i,behavior:s}={})=>{let r={target:t+(i??0),smooth:s==="smooth"};return this.pendingWrite=r,this.options.scrollToFn(t-this._holdOffset,{behavior:s,adjustments:i},this),r},this.getCommandWrittenOffset=()=>this.scrollState!==null&&this.pendingWrite!==null&&!this.pendingWrite.smooth?this.pendingWrite.target:null,this._awaitingCommandReadBack=()=>{let t=this.getCommandWrittenOffset();return!(Xa()&&this._iosGesture.dragging())&&t!==null&&!Fs(t,this.getScrollOffset())},this._followOffsetTarget=t=>{this.scrollState!==null&&this.scrollState.index==null&&(this.scrollState.lastTargetOffset+=t)},this.measure=()=>{this.pendingMin=null,this.itemSizeCache.clear(),this.laneAssignments.clear(),this.itemSizeCacheVersion++,this.notify(!1)},this.setOptions(e)}get scrollAdjustments(){return 0}applyScrollAdjustment(e,t){if(e===0)return!1;if(this._followOffsetTarget(e),this._canWriteScroll()){let i=this.getScrollOffset();this._clampedAdjustment=this._clampedBy(i+e);let s=this._scrollToOffset(i,{adjustments:e,behavior:t});return this.scrollOffset!==null&&(this.pendingWrite===s&&(this.scrollOffset+=e),this.scrollOffset<0&&(this.scrollOffset=0)),!0}else return this._holdOffset+=e,this.scrollOffset!==null&&(this.scrollOffset+=e),!0}scheduleScrollReconcile(){if(!this.targetWindow){this.scrollState=null;return}this.rafId==null&&(this.rafId=this.targetWindow.requestAnimationFrame(()=>{this.rafId=null,this.reconcileScroll()}))}getScrollStateTarget(e){let t=e.toEnd?[Math.max(this.getMaxScrollOffset(),0)]:e.index!=null?this.getOffsetForIndex(e.index,e.align):void 0;return t?t[0]:e.lastTargetOffset}reconcileScroll(){if(!this.scrollState||!this.scrollElement)return;if(this.now()-this.scrollState.startedAt>5e3){this.scrollState=null;return}if(this.scrollState.phase==="queued"){this.scheduleScrollReconcile();return}this.getMeasurements();let i=this.getScrollStateTarget(this.scrollState),s=this.scrollState.index==null?1:this.options.useAnimationFrameWithResizeObserver?3:2,r=i!==this.scrollState.lastTargetOffset;if(!r&&Fs(i,this.getScrollOffset())){if(this.scrollState.phase==="smooth"?this.scrollState.phase="smoothLanded":this.scrollState.phase==="smoothFinishing"&&(this.scrollState.phase="instant"),this.scrollState.stableFrames++,this.scrollState.stableFrames>=s){this.getScrollOffset()!==i&&this._scrollToOffset(i,{behavior:"auto"}),this.scrollState=null;return}}else if(this.scrollState.stableFrames=0,r){let o=this.getSize()||600,a=Math.abs(i-this.getScrollOffset()),l=qa(this.scrollState)&&a>o;this.scrollState.lastTargetOffset=i,l?this.scrollState.phase="smooth":this.scrollState.phase==="smooth"?this.scrollState.phase="smoothFinishing":this.scrollState.phase==="smoothLanded"&&(this.scrollState.phase="instant"),this._scrollToOffset(i,{behavior:l?"smooth":"auto"})}this.scheduleScrollReconcile()}_startScroll(e,t,i,s){this.pendingScrollAnchor=null,this._clampedAdjustment=null;let r=this._iosGesture.tail();if(s==="absolute"&&r!==null){if(r==="fling"&&qg()){this._stopMomentum(()=>{let o=this.scrollState;o?.phase!=="queued"||this._iosGesture.tail()!=="fling"||this._reportedOverscroll||(this._iosGesture.end(),this._flushHoldIfReady(!0),this._writeAwaitingCommand())}),this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,phase:"queued",behavior:i,samples:[]},this.scheduleScrollReconcile();return}this._iosGesture.end()}this.scrollState={...e,startedAt:this.now(),lastTargetOffset:t,stableFrames:0,behavior:i,phase:Jg(i,e.index!=null&&Fs(t,this.getScrollOffset()))},this._scrollToOffset(t,{behavior:i}),this.scheduleScrollReconcile()}},t0=(n,e,t,i)=>{for(;n<=e;){let s=(n+e)/2|0,r=t(s);if(r<i)n=s+1;else if(r>i)e=s-1;else return s}return n>0?n-1:0};function SS(n,e,t){let i=0;for(;i<=e;){let s=(i+e)/2|0,r=n[s*2];if(r<t)i=s+1;else if(r>t)e=s-1;else return s}return i>0?i-1:0}function MS(n,e,t,i,s){let r=n.length-1;if(n.length<=i)return{startIndex:0,endIndex:r};if(i===1&&s!==null){let c=SS(s,r,t),u=c,h=t+e;for(;u<r&&s[u*2]+s[u*2+1]<h;)u++;return{startIndex:c,endIndex:u}}let a=t0(0,r,c=>n[c].start,t),l=a;if(i===1)for(;l<r&&n[l].end<t+e;)l++;else if(i>1){let c=Array(i).fill(0);for(;l<r&&c.some(h=>h<t+e);){let h=n[l];c[h.lane]=h.end,l++}let u=Array(i).fill(t+e);for(;a>=0&&u.some(h=>h>=t);){let h=n[a];u[h.lane]=h.start,a--}a=Math.max(0,a-a%i),l=Math.min(r,l+(i-1-l%i))}return{startIndex:a,endIndex:l}}var Tr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2};var F0=0,Td=1,O0=2;var El=1,U0=2,oa=3,Ar=0,fi=1,mi=2,Zr=0,aa=1,Ad=2,Ed=3,Cd=4,B0=5;var Kr=100,k0=101,z0=102,V0=103,G0=104,H0=200,W0=201,$0=202,X0=203,Rd=204,Pd=205,q0=206,Y0=207,j0=208,J0=209,Z0=210,K0=211,Q0=212,e_=213,t_=214,Zc=0,Kc=1,Qc=2,jo=3,eu=4,tu=5,nu=6,iu=7,Cu=0,n_=1,i_=2,Ss=0,Id=1,Ld=2,Nd=3,Dd=4,Fd=5,Od=6,Ud=7;var Bd=300,Qr=301,la=302,Ru=303,Pu=304,su=1e3,vs=1001,ru=1002,Hn=1003,s_=1004;var Cl=1005;var hi=1006,Iu=1007;var Js=1008;var gi=1009,kd=1010,zd=1011,ca=1012,Lu=1013,ts=1014,Hi=1015,ns=1016,Nu=1017,Du=1018,eo=1020,Vd=35902,Gd=35899,Hd=1021,Wd=1022,is=1023,Hs=1026,Zs=1027,Fu=1028,Ou=1029,Er=1030,Uu=1031;var Bu=1033,Rl=33776,Pl=33777,Il=33778,Ll=33779,ku=35840,zu=35841,Vu=35842,Gu=35843,Hu=36196,Wu=37492,$u=37496,Xu=37488,qu=37489,Nl=37490,Yu=37491,ju=37808,Ju=37809,Zu=37810,Ku=37811,Qu=37812,eh=37813,th=37814,nh=37815,ih=37816,sh=37817,rh=37818,oh=37819,ah=37820,lh=37821,ch=36492,uh=36494,hh=36495,fh=36283,dh=36284,Dl=36285,ph=36286;var sl=2300,ou=2301,jc=2302,md=2303,gd=2400,_d=2401,xd=2402;var r_=3200;var mh=0,o_=1,Ks="",ni="srgb",rl="srgb-linear",ol="linear",Dt="srgb";var Jc=7680;var a_=519,l_=512,c_=513,u_=514,$d=515,h_=516,f_=517,Xd=518,qd=519,d_=35044;var Yd="300 es",Vi=2e3,Jo=2001;function wS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function TS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function al(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function p_(){let n=al("canvas");return n.style.display="block",n}var n0={},Zo=null;function jd(...n){let e="THREE."+n.shift();Zo?Zo("log",e,...n):console.log(e,...n)}function m_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=m_(n);let e="THREE."+n.shift();if(Zo)Zo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function nt(...n){n=m_(n);let e="THREE."+n.shift();if(Zo)Zo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function tl(...n){let e=n.join(" ");e in n0||(n0[e]=!0,je(...n))}function g_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var __={[Zc]:Zc,[Qc]:nu,[eu]:eu,[jo]:tu,[Kc]:Kc,[nu]:Qc,[iu]:iu,[tu]:jo},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},ei=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],i0=1234567,nl=Math.PI/180,Ko=180/Math.PI;function ua(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ei[n&255]+ei[n>>8&255]+ei[n>>16&255]+ei[n>>24&255]+"-"+ei[e&255]+ei[e>>8&255]+"-"+ei[e>>16&15|64]+ei[e>>24&255]+"-"+ei[t&63|128]+ei[t>>8&255]+"-"+ei[t>>16&255]+ei[t>>24&255]+ei[i&255]+ei[i>>8&255]+ei[i>>16&255]+ei[i>>24&255]).toLowerCase()}function St(n,e,t){return Math.max(e,Math.min(t,n))}function Jd(n,e){return(n%e+e)%e}function AS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function ES(n,e,t){return n!==e?(t-n)/(e-n):0}function il(n,e,t){return(1-t)*n+t*e}function CS(n,e,t,i){return il(n,e,1-Math.exp(-t*i))}function RS(n,e=1){return e-Math.abs(Jd(n,e*2)-e)}function PS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function IS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function LS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function NS(n,e){return n+Math.random()*(e-n)}function DS(n){return n*(.5-Math.random())}function FS(n){n!==void 0&&(i0=n);let e=i0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function OS(n){return n*nl}function US(n){return n*Ko}function BS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function kS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Zd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function zS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),y=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*y,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*y,a*c);break;case"ZYZ":n.set(l*y,l*d,a*u,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Kd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function x_(n,e){if(e.constructor===Float32Array)return n;let t=Kd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function y_(n,e){if(e.constructor===Float32Array)return n;let t=Kd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var gh={DEG2RAD:nl,RAD2DEG:Ko,generateUUID:ua,clamp:St,euclideanModulo:Jd,mapLinear:AS,inverseLerp:ES,lerp:il,damp:CS,pingpong:RS,smoothstep:PS,smootherstep:IS,randInt:LS,randFloat:NS,randFloatSpread:DS,seededRandom:FS,degToRad:OS,radToDeg:US,isPowerOfTwo:BS,ceilPowerOfTwo:kS,floorPowerOfTwo:Zd,setQuaternionFromProperEuler:zS,normalize:y_,denormalize:x_},Qe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(St(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],y=r[o+2],v=r[o+3];if(h!==v||l!==f||c!==d||u!==y){let g=l*f+c*d+u*y+h*v;g<0&&(f=-f,d=-d,y=-y,v=-v,g=-g);let x=1-a;if(g<.9995){let _=Math.acos(g),M=Math.sin(_);x=Math.sin(x*_)/M,a=Math.sin(a*_)/M,l=l*x+f*a,c=c*x+d*a,u=u*x+y*a,h=h*x+v*a}else{l=l*x+f*a,c=c*x+d*a,u=u*x+y*a,h=h*x+v*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],y=r[o+3];return e[t]=a*y+u*h+l*d-c*f,e[t+1]=l*y+u*f+c*h-a*d,e[t+2]=c*y+u*d+a*f-l*h,e[t+3]=u*y-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),y=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h-f*d*y;break;case"YXZ":this._x=f*u*h+c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h+f*d*y;break;case"ZXY":this._x=f*u*h-c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h-f*d*y;break;case"ZYX":this._x=f*u*h-c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h+f*d*y;break;case"YZX":this._x=f*u*h+c*d*y,this._y=c*d*h+f*u*y,this._z=c*u*y-f*d*h,this._w=c*u*h-f*d*y;break;case"XZY":this._x=f*u*h-c*d*y,this._y=c*d*h-f*u*y,this._z=c*u*y+f*d*h,this._w=c*u*h+f*d*y;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(St(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(s0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(s0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Yf.copy(this).projectOnVector(e),this.sub(Yf)}reflect(e){return this.sub(Yf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(St(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yf=new H,s0=new fn,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],y=i[8],v=s[0],g=s[3],x=s[6],_=s[1],M=s[4],S=s[7],T=s[2],b=s[5],m=s[8];return r[0]=o*v+a*_+l*T,r[3]=o*g+a*M+l*b,r[6]=o*x+a*S+l*m,r[1]=c*v+u*_+h*T,r[4]=c*g+u*M+h*b,r[7]=c*x+u*S+h*m,r[2]=f*v+d*_+y*T,r[5]=f*g+d*M+y*b,r[8]=f*x+d*S+y*m,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,y=t*h+i*f+s*d;if(y===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/y;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return tl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(jf.makeScale(e,t)),this}rotate(e){return tl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(jf.makeRotation(-e)),this}translate(e,t){return tl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(jf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},jf=new it,r0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),o0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function VS(){let n={enabled:!0,workingColorSpace:rl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=Gs(s.r),s.g=Gs(s.g),s.b=Gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=Yo(s.r),s.g=Yo(s.g),s.b=Yo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ks?ol:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[rl]:{primaries:e,whitePoint:i,transfer:ol,toXYZ:r0,fromXYZ:o0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ni},outputColorSpaceConfig:{drawingBufferColorSpace:ni}},[ni]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:r0,fromXYZ:o0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ni}}}),n}var bt=VS();function Gs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Yo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Do,au=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Do===void 0&&(Do=al("canvas")),Do.width=e.width,Do.height=e.height;let s=Do.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Do}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=al("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Gs(t[i]/255)*255):t[i]=Gs(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},GS=0,Qo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:GS++}),this.uuid=ua(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Jf(s[o].image)):r.push(Jf(s[o]))}else r=Jf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Jf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?au.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var HS=0,Zf=new H,pi=class n extends Qi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=vs,s=vs,r=hi,o=Js,a=is,l=gi,c=n.DEFAULT_ANISOTROPY,u=Ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:HS++}),this.uuid=ua(),this.name="",this.source=new Qo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Qe(0,0),this.repeat=new Qe(1,1),this.center=new Qe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zf).x}get height(){return this.source.getSize(Zf).y}get depth(){return this.source.getSize(Zf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Bd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case su:e.x=e.x-Math.floor(e.x);break;case vs:e.x=e.x<0?0:1;break;case ru:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case su:e.y=e.y-Math.floor(e.y);break;case vs:e.y=e.y<0?0:1;break;case ru:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};pi.DEFAULT_IMAGE=null;pi.DEFAULT_MAPPING=Bd;pi.DEFAULT_ANISOTROPY=1;var Wt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],y=l[9],v=l[2],g=l[6],x=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(y-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(y+g)<.1&&Math.abs(c+d+x-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,S=(d+1)/2,T=(x+1)/2,b=(u+f)/4,m=(h+v)/4,w=(y+g)/4;return M>S&&M>T?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=b/i,r=m/i):S>T?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=b/s,r=w/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=m/r,s=w/r),this.set(i,s,r,t),this}let _=Math.sqrt((g-y)*(g-y)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(_)<.001&&(_=1),this.x=(g-y)/_,this.y=(h-v)/_,this.z=(f-u)/_,this.w=Math.acos((c+d+x-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this.w=St(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this.w=St(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},lu=class extends Qi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:hi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Wt(0,0,e,t),this.scissorTest=!1,this.viewport=new Wt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new pi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:hi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Qo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends lu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},ll=class extends pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=vs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var cu=class extends pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Hn,this.minFilter=Hn,this.wrapR=vs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Je=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,y,v,g){let x=this.elements;return x[0]=e,x[4]=t,x[8]=i,x[12]=s,x[1]=r,x[5]=o,x[9]=a,x[13]=l,x[2]=c,x[6]=u,x[10]=h,x[14]=f,x[3]=d,x[7]=y,x[11]=v,x[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Fo.setFromMatrixColumn(e,0).length(),r=1/Fo.setFromMatrixColumn(e,1).length(),o=1/Fo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,y=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+y*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=y+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,y=c*u,v=c*h;t[0]=f+v*a,t[4]=y*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-y,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,y=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=y+d*a,t[1]=d+y*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,y=a*u,v=a*h;t[0]=l*u,t[4]=y*c-d,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=d*c-y,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,y=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=y*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+y,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,d=o*c,y=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=d*h-y,t[2]=y*h-d,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(WS,e,$S)}lookAt(e,t,i){let s=this.elements;return Ai.subVectors(e,t),Ai.lengthSq()===0&&(Ai.z=1),Ai.normalize(),pr.crossVectors(i,Ai),pr.lengthSq()===0&&(Math.abs(i.z)===1?Ai.x+=1e-4:Ai.z+=1e-4,Ai.normalize(),pr.crossVectors(i,Ai)),pr.normalize(),Ac.crossVectors(Ai,pr),s[0]=pr.x,s[4]=Ac.x,s[8]=Ai.x,s[1]=pr.y,s[5]=Ac.y,s[9]=Ai.y,s[2]=pr.z,s[6]=Ac.z,s[10]=Ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],y=i[2],v=i[6],g=i[10],x=i[14],_=i[3],M=i[7],S=i[11],T=i[15],b=s[0],m=s[4],w=s[8],R=s[12],C=s[1],I=s[5],E=s[9],F=s[13],D=s[2],z=s[6],X=s[10],k=s[14],se=s[3],q=s[7],J=s[11],ne=s[15];return r[0]=o*b+a*C+l*D+c*se,r[4]=o*m+a*I+l*z+c*q,r[8]=o*w+a*E+l*X+c*J,r[12]=o*R+a*F+l*k+c*ne,r[1]=u*b+h*C+f*D+d*se,r[5]=u*m+h*I+f*z+d*q,r[9]=u*w+h*E+f*X+d*J,r[13]=u*R+h*F+f*k+d*ne,r[2]=y*b+v*C+g*D+x*se,r[6]=y*m+v*I+g*z+x*q,r[10]=y*w+v*E+g*X+x*J,r[14]=y*R+v*F+g*k+x*ne,r[3]=_*b+M*C+S*D+T*se,r[7]=_*m+M*I+S*z+T*q,r[11]=_*w+M*E+S*X+T*J,r[15]=_*R+M*F+S*k+T*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],y=e[3],v=e[7],g=e[11],x=e[15],_=l*d-c*f,M=a*d-c*h,S=a*f-l*h,T=o*d-c*u,b=o*f-l*u,m=o*h-a*u;return t*(v*_-g*M+x*S)-i*(y*_-g*T+x*b)+s*(y*M-v*T+x*m)-r*(y*S-v*b+g*m)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],y=e[12],v=e[13],g=e[14],x=e[15],_=t*a-i*o,M=t*l-s*o,S=t*c-r*o,T=i*l-s*a,b=i*c-r*a,m=s*c-r*l,w=u*v-h*y,R=u*g-f*y,C=u*x-d*y,I=h*g-f*v,E=h*x-d*v,F=f*x-d*g,D=_*F-M*E+S*I+T*C-b*R+m*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/D;return e[0]=(a*F-l*E+c*I)*z,e[1]=(s*E-i*F-r*I)*z,e[2]=(v*m-g*b+x*T)*z,e[3]=(f*b-h*m-d*T)*z,e[4]=(l*C-o*F-c*R)*z,e[5]=(t*F-s*C+r*R)*z,e[6]=(g*S-y*m-x*M)*z,e[7]=(u*m-f*S+d*M)*z,e[8]=(o*E-a*C+c*w)*z,e[9]=(i*C-t*E-r*w)*z,e[10]=(y*b-v*S+x*_)*z,e[11]=(h*S-u*b-d*_)*z,e[12]=(a*R-o*I-l*w)*z,e[13]=(t*I-i*R+s*w)*z,e[14]=(v*M-y*T-g*_)*z,e[15]=(u*T-h*M+f*_)*z,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,y=r*h,v=o*u,g=o*h,x=a*h,_=l*c,M=l*u,S=l*h,T=i.x,b=i.y,m=i.z;return s[0]=(1-(v+x))*T,s[1]=(d+S)*T,s[2]=(y-M)*T,s[3]=0,s[4]=(d-S)*b,s[5]=(1-(f+x))*b,s[6]=(g+_)*b,s[7]=0,s[8]=(y+M)*m,s[9]=(g-_)*m,s[10]=(1-(f+v))*m,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Fo.set(s[0],s[1],s[2]).length(),a=Fo.set(s[4],s[5],s[6]).length(),l=Fo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ji.copy(this);let c=1/o,u=1/a,h=1/l;return ji.elements[0]*=c,ji.elements[1]*=c,ji.elements[2]*=c,ji.elements[4]*=u,ji.elements[5]*=u,ji.elements[6]*=u,ji.elements[8]*=h,ji.elements[9]*=h,ji.elements[10]*=h,t.setFromRotationMatrix(ji),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Vi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),y,v;if(l)y=r/(o-r),v=o*r/(o-r);else if(a===Vi)y=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Jo)y=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=y,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Vi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),y,v;if(l)y=1/(o-r),v=o/(o-r);else if(a===Vi)y=-2/(o-r),v=-(o+r)/(o-r);else if(a===Jo)y=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=y,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Fo=new H,ji=new Je,WS=new H(0,0,0),$S=new H(1,1,1),pr=new H,Ac=new H,Ai=new H,a0=new Je,l0=new fn,Ws=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(St(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-St(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(St(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-St(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(St(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-St(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return a0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(a0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return l0.setFromEuler(this),this.setFromQuaternion(l0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ws.DEFAULT_ORDER="XYZ";var ea=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},XS=0,c0=new H,Oo=new fn,Os=new Je,Ec=new H,Ya=new H,qS=new H,YS=new fn,u0=new H(1,0,0),h0=new H(0,1,0),f0=new H(0,0,1),d0={type:"added"},jS={type:"removed"},Uo={type:"childadded",child:null},Kf={type:"childremoved",child:null},Yn=class n extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:XS++}),this.uuid=ua(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new H,t=new Ws,i=new fn,s=new H(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Je},normalMatrix:{value:new it}}),this.matrix=new Je,this.matrixWorld=new Je,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ea,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Oo.setFromAxisAngle(e,t),this.quaternion.multiply(Oo),this}rotateOnWorldAxis(e,t){return Oo.setFromAxisAngle(e,t),this.quaternion.premultiply(Oo),this}rotateX(e){return this.rotateOnAxis(u0,e)}rotateY(e){return this.rotateOnAxis(h0,e)}rotateZ(e){return this.rotateOnAxis(f0,e)}translateOnAxis(e,t){return c0.copy(e).applyQuaternion(this.quaternion),this.position.add(c0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(u0,e)}translateY(e){return this.translateOnAxis(h0,e)}translateZ(e){return this.translateOnAxis(f0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Os.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Ec.copy(e):Ec.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ya.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Os.lookAt(Ya,Ec,this.up):Os.lookAt(Ec,Ya,this.up),this.quaternion.setFromRotationMatrix(Os),s&&(Os.extractRotation(s.matrixWorld),Oo.setFromRotationMatrix(Os),this.quaternion.premultiply(Oo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(d0),Uo.child=e,this.dispatchEvent(Uo),Uo.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(jS),Kf.child=e,this.dispatchEvent(Kf),Kf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Os.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Os.multiply(e.parent.matrixWorld)),e.applyMatrix4(Os),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(d0),Uo.child=e,this.dispatchEvent(Uo),Uo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ya,e,qS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ya,YS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),y=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),y.length>0&&(i.nodes=y)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Yn.DEFAULT_UP=new H(0,1,0);Yn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Yn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var bs=class extends Yn{constructor(){super(),this.isGroup=!0,this.type="Group"}},JS={type:"move"},ta=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new bs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new bs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new bs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),x=this._getHandJoint(c,v);g!==null&&(x.matrix.fromArray(g.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=g.radius),x.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,y=.005;c.inputState.pinching&&f>d+y?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-y&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(JS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new bs;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},v_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},mr={h:0,s:0,l:0},Cc={h:0,s:0,l:0};function Qf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var rt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ni){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=i,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=bt.workingColorSpace){if(e=Jd(e,1),t=St(t,0,1),i=St(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Qf(o,r,e+1/3),this.g=Qf(o,r,e),this.b=Qf(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=ni){function i(r){r!==void 0&&parseFloat(r)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ni){let i=v_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gs(e.r),this.g=Gs(e.g),this.b=Gs(e.b),this}copyLinearToSRGB(e){return this.r=Yo(e.r),this.g=Yo(e.g),this.b=Yo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ni){return bt.workingToColorSpace(ti.copy(this),e),Math.round(St(ti.r*255,0,255))*65536+Math.round(St(ti.g*255,0,255))*256+Math.round(St(ti.b*255,0,255))}getHexString(e=ni){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(ti.copy(this),t);let i=ti.r,s=ti.g,r=ti.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(ti.copy(this),t),e.r=ti.r,e.g=ti.g,e.b=ti.b,e}getStyle(e=ni){bt.workingToColorSpace(ti.copy(this),e);let t=ti.r,i=ti.g,s=ti.b;return e!==ni?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(mr),this.setHSL(mr.h+e,mr.s+t,mr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(mr),e.getHSL(Cc);let i=il(mr.h,Cc.h,t),s=il(mr.s,Cc.s,t),r=il(mr.l,Cc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ti=new rt;rt.NAMES=v_;var es=class extends Yn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ws,this.environmentIntensity=1,this.environmentRotation=new Ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ji=new H,Us=new H,ed=new H,Bs=new H,Bo=new H,ko=new H,p0=new H,td=new H,nd=new H,id=new H,sd=new Wt,rd=new Wt,od=new Wt,yr=class n{constructor(e=new H,t=new H,i=new H){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ji.subVectors(e,t),s.cross(Ji);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ji.subVectors(s,t),Us.subVectors(i,t),ed.subVectors(e,t);let o=Ji.dot(Ji),a=Ji.dot(Us),l=Ji.dot(ed),c=Us.dot(Us),u=Us.dot(ed),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,y=(o*u-a*l)*f;return r.set(1-d-y,y,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Bs)===null?!1:Bs.x>=0&&Bs.y>=0&&Bs.x+Bs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Bs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Bs.x),l.addScaledVector(o,Bs.y),l.addScaledVector(a,Bs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return sd.setScalar(0),rd.setScalar(0),od.setScalar(0),sd.fromBufferAttribute(e,t),rd.fromBufferAttribute(e,i),od.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(sd,r.x),o.addScaledVector(rd,r.y),o.addScaledVector(od,r.z),o}static isFrontFacing(e,t,i,s){return Ji.subVectors(i,t),Us.subVectors(e,t),Ji.cross(Us).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ji.subVectors(this.c,this.b),Us.subVectors(this.a,this.b),Ji.cross(Us).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Bo.subVectors(s,i),ko.subVectors(r,i),td.subVectors(e,i);let l=Bo.dot(td),c=ko.dot(td);if(l<=0&&c<=0)return t.copy(i);nd.subVectors(e,s);let u=Bo.dot(nd),h=ko.dot(nd);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Bo,o);id.subVectors(e,r);let d=Bo.dot(id),y=ko.dot(id);if(y>=0&&d<=y)return t.copy(r);let v=d*c-l*y;if(v<=0&&c>=0&&y<=0)return a=c/(c-y),t.copy(i).addScaledVector(ko,a);let g=u*y-d*h;if(g<=0&&h-u>=0&&d-y>=0)return p0.subVectors(r,s),a=(h-u)/(h-u+(d-y)),t.copy(s).addScaledVector(p0,a);let x=1/(g+v+f);return o=v*x,a=f*x,t.copy(i).addScaledVector(Bo,o).addScaledVector(ko,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Pi=class{constructor(e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zi):Zi.fromBufferAttribute(r,o),Zi.applyMatrix4(e.matrixWorld),this.expandByPoint(Zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Rc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Rc.copy(i.boundingBox)),Rc.applyMatrix4(e.matrixWorld),this.union(Rc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zi),Zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ja),Pc.subVectors(this.max,ja),zo.subVectors(e.a,ja),Vo.subVectors(e.b,ja),Go.subVectors(e.c,ja),gr.subVectors(Vo,zo),_r.subVectors(Go,Vo),Gr.subVectors(zo,Go);let t=[0,-gr.z,gr.y,0,-_r.z,_r.y,0,-Gr.z,Gr.y,gr.z,0,-gr.x,_r.z,0,-_r.x,Gr.z,0,-Gr.x,-gr.y,gr.x,0,-_r.y,_r.x,0,-Gr.y,Gr.x,0];return!ad(t,zo,Vo,Go,Pc)||(t=[1,0,0,0,1,0,0,0,1],!ad(t,zo,Vo,Go,Pc))?!1:(Ic.crossVectors(gr,_r),t=[Ic.x,Ic.y,Ic.z],ad(t,zo,Vo,Go,Pc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ks[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ks[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ks[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ks[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ks[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ks[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ks[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ks[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ks),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ks=[new H,new H,new H,new H,new H,new H,new H,new H],Zi=new H,Rc=new Pi,zo=new H,Vo=new H,Go=new H,gr=new H,_r=new H,Gr=new H,ja=new H,Pc=new H,Ic=new H,Hr=new H;function ad(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Hr.fromArray(n,r);let a=s.x*Math.abs(Hr.x)+s.y*Math.abs(Hr.y)+s.z*Math.abs(Hr.z),l=e.dot(Hr),c=t.dot(Hr),u=i.dot(Hr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var wn=new H,Lc=new Qe,ZS=0,Ft=class extends Qi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ZS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=d_,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?Kd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Lc.fromBufferAttribute(this,t),Lc.applyMatrix3(e),this.setXY(t,Lc.x,Lc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix3(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyMatrix4(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.applyNormalMatrix(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)wn.fromBufferAttribute(this,t),wn.transformDirection(e),this.setXYZ(t,wn.x,wn.y,wn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):x_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):y_(e,this.array)}},cl=class extends Ft{constructor(e,t,i){super(new Int8Array(e),t,i)}},ul=class extends Ft{constructor(e,t,i){super(new Uint8Array(e),t,i)}};var hl=class extends Ft{constructor(e,t,i){super(new Int16Array(e),t,i)}},Xr=class extends Ft{constructor(e,t,i){super(new Uint16Array(e),t,i)}},fl=class extends Ft{constructor(e,t,i){super(new Int32Array(e),t,i)}},qr=class extends Ft{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Pn=class extends Ft{constructor(e,t,i){super(new Float32Array(e),t,i)}},KS=new Pi,Ja=new H,ld=new H,$s=class{constructor(e=new H,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):KS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ja.subVectors(e,this.center);let t=Ja.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ja,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ld.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ja.copy(e.center).add(ld)),this.expandByPoint(Ja.copy(e.center).sub(ld))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},QS=0,zi=new Je,cd=new Yn,Ho=new H,Ei=new Pi,Za=new Pi,Gn=new H,jn=class n extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:QS++}),this.uuid=ua(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(wS(e)?qr:Xr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return zi.makeRotationFromQuaternion(e),this.applyMatrix4(zi),this}rotateX(e){return zi.makeRotationX(e),this.applyMatrix4(zi),this}rotateY(e){return zi.makeRotationY(e),this.applyMatrix4(zi),this}rotateZ(e){return zi.makeRotationZ(e),this.applyMatrix4(zi),this}translate(e,t,i){return zi.makeTranslation(e,t,i),this.applyMatrix4(zi),this}scale(e,t,i){return zi.makeScale(e,t,i),this.applyMatrix4(zi),this}lookAt(e){return cd.lookAt(e),cd.updateMatrix(),this.applyMatrix4(cd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ho).negate(),this.translate(Ho.x,Ho.y,Ho.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Pn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ei.setFromBufferAttribute(r),this.morphTargetsRelative?(Gn.addVectors(this.boundingBox.min,Ei.min),this.boundingBox.expandByPoint(Gn),Gn.addVectors(this.boundingBox.max,Ei.max),this.boundingBox.expandByPoint(Gn)):(this.boundingBox.expandByPoint(Ei.min),this.boundingBox.expandByPoint(Ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new $s);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(e){let i=this.boundingSphere.center;if(Ei.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Za.setFromBufferAttribute(a),this.morphTargetsRelative?(Gn.addVectors(Ei.min,Za.min),Ei.expandByPoint(Gn),Gn.addVectors(Ei.max,Za.max),Ei.expandByPoint(Gn)):(Ei.expandByPoint(Za.min),Ei.expandByPoint(Za.max))}Ei.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Gn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Gn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Gn.fromBufferAttribute(a,c),l&&(Ho.fromBufferAttribute(e,c),Gn.add(Ho)),s=Math.max(s,i.distanceToSquared(Gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ft(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let R=0;R<i.count;R++)a[R]=new H,l[R]=new H;let u=new H,h=new H,f=new H,d=new Qe,y=new Qe,v=new Qe,g=new H,x=new H;function _(R,C,I){c[R]=c[C]=c[I]=1,u.fromBufferAttribute(i,R),h.fromBufferAttribute(i,C),f.fromBufferAttribute(i,I),d.fromBufferAttribute(r,R),y.fromBufferAttribute(r,C),v.fromBufferAttribute(r,I),h.sub(u),f.sub(u),y.sub(d),v.sub(d);let E=1/(y.x*v.y-v.x*y.y);isFinite(E)&&(g.copy(h).multiplyScalar(v.y).addScaledVector(f,-y.y).multiplyScalar(E),x.copy(f).multiplyScalar(y.x).addScaledVector(h,-v.x).multiplyScalar(E),a[R].add(g),a[C].add(g),a[I].add(g),l[R].add(x),l[C].add(x),l[I].add(x))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let R=0,C=M.length;R<C;++R){let I=M[R],E=I.start,F=I.count;for(let D=E,z=E+F;D<z;D+=3)_(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let S=new H,T=new H,b=new H,m=new H;function w(R){b.fromBufferAttribute(s,R),m.copy(b);let C=a[R];S.copy(C),S.sub(b.multiplyScalar(b.dot(C))).normalize(),T.crossVectors(m,C);let E=T.dot(l[R])<0?-1:1;o.setXYZW(R,S.x,S.y,S.z,E)}for(let R=0,C=i.count;R<C;++R)c[R]&&w(R);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ft(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(e)for(let f=0,d=e.count;f<d;f+=3){let y=e.getX(f+0),v=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,y),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,y),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(y,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Gn.fromBufferAttribute(e,t),Gn.normalize(),e.setXYZ(t,Gn.x,Gn.y,Gn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,y=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let x=0;x<u;x++)f[y++]=c[d++]}return new Ft(f,u,h)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ud=new H,eM=new H,tM=new it,Ki=class{constructor(e=new H(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=ud.subVectors(i,t).cross(eM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(ud),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||tM.getNormalMatrix(e),s=this.coplanarPoint(ud).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},nM=0,Xs=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:nM++}),this.uuid=ua(),this.name="",this.type="Material",this.blending=aa,this.side=Ar,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rd,this.blendDst=Pd,this.blendEquation=Kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=jo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=a_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Jc,this.stencilZFail=Jc,this.stencilZPass=Jc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ki().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Qe().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Qe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var zs=new H,hd=new H,Nc=new H,Dc=new H,na=class{constructor(e=new H,t=new H(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,zs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=zs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(zs.copy(this.origin).addScaledVector(this.direction,t),zs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){hd.copy(e).add(t).multiplyScalar(.5),Nc.copy(t).sub(e).normalize(),Dc.copy(this.origin).sub(hd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Nc),a=Dc.dot(this.direction),l=-Dc.dot(Nc),c=Dc.lengthSq(),u=Math.abs(1-o*o),h,f,d,y;if(u>0)if(h=o*l-a,f=o*a-l,y=r*u,h>=0)if(f>=-y)if(f<=y){let v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-y?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=y?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(hd).addScaledVector(Nc,f),d}intersectSphere(e,t){if(e.radius<0)return null;zs.subVectors(e.center,this.origin);let i=zs.dot(this.direction),s=zs.dot(zs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,zs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,y=t.x-o.x,v=t.y-o.y,g=t.z-o.z,x=i.x-o.x,_=i.y-o.y,M=i.z-o.z,S=Math.abs(l),T=Math.abs(c),b=Math.abs(u),m,w,R,C,I,E,F,D,z,X,k,se;if(S>=T&&S>=b?(R=l,E=h,z=y,se=x,l>=0?(m=c,w=u,C=f,I=d,F=v,D=g,X=_,k=M):(m=u,w=c,C=d,I=f,F=g,D=v,X=M,k=_)):T>=b?(R=c,E=f,z=v,se=_,c>=0?(m=u,w=l,C=d,I=h,F=g,D=y,X=M,k=x):(m=l,w=u,C=h,I=d,F=y,D=g,X=x,k=M)):(R=u,E=d,z=g,se=M,u>=0?(m=l,w=c,C=h,I=f,F=y,D=v,X=x,k=_):(m=c,w=l,C=f,I=h,F=v,D=y,X=_,k=x)),R===0)return null;let q=m/R,J=w/R,ne=1/R,pe=C-q*E,te=I-J*E,j=F-q*z,he=D-J*z,me=X-q*se,Q=k-J*se,ue=me*he-Q*j,Me=pe*Q-te*me,We=j*te-he*pe;if(s){if(ue<0||Me<0||We<0)return null}else if((ue<0||Me<0||We<0)&&(ue>0||Me>0||We>0))return null;let Ge=ue+Me+We;if(Ge===0)return null;let pt=ne*(ue*E+Me*z+We*se);return(Ge>0?pt<0:pt>0)?null:this.at(pt/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},qs=class extends Xs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ws,this.combine=Cu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},m0=new Je,Wr=new na,Fc=new $s,g0=new H,Oc=new H,Uc=new H,Bc=new H,fd=new H,kc=new H,_0=new H,zc=new H,Tn=class extends Yn{constructor(e=new jn,t=new qs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){kc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(fd.fromBufferAttribute(h,e),o?kc.addScaledVector(fd,u):kc.addScaledVector(fd.sub(t),u))}t.add(kc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Fc.copy(i.boundingSphere),Fc.applyMatrix4(r),Wr.copy(e.ray).recast(e.near),!(Fc.containsPoint(Wr.origin)===!1&&(Wr.intersectSphere(Fc,g0)===null||Wr.origin.distanceToSquared(g0)>(e.far-e.near)**2))&&(m0.copy(r).invert(),Wr.copy(e.ray).applyMatrix4(m0),!(i.boundingBox!==null&&Wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Wr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let y=0,v=f.length;y<v;y++){let g=f[y],x=o[g.materialIndex],_=Math.max(g.start,d.start),M=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let S=_,T=M;S<T;S+=3){let b=a.getX(S),m=a.getX(S+1),w=a.getX(S+2);s=Vc(this,x,e,i,c,u,h,b,m,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let y=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let g=y,x=v;g<x;g+=3){let _=a.getX(g),M=a.getX(g+1),S=a.getX(g+2);s=Vc(this,o,e,i,c,u,h,_,M,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let y=0,v=f.length;y<v;y++){let g=f[y],x=o[g.materialIndex],_=Math.max(g.start,d.start),M=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let S=_,T=M;S<T;S+=3){let b=S,m=S+1,w=S+2;s=Vc(this,x,e,i,c,u,h,b,m,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let y=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let g=y,x=v;g<x;g+=3){let _=g,M=g+1,S=g+2;s=Vc(this,o,e,i,c,u,h,_,M,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function iM(n,e,t,i,s,r,o,a){let l;if(e.side===fi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ar,a),l===null)return null;zc.copy(a),zc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(zc);return c<t.near||c>t.far?null:{distance:c,point:zc.clone(),object:n}}function Vc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Oc),n.getVertexPosition(l,Uc),n.getVertexPosition(c,Bc);let u=iM(n,e,t,i,Oc,Uc,Bc,_0);if(u){let h=new H;yr.getBarycoord(_0,Oc,Uc,Bc,h),s&&(u.uv=yr.getInterpolatedAttribute(s,a,l,c,h,new Qe)),r&&(u.uv1=yr.getInterpolatedAttribute(r,a,l,c,h,new Qe)),o&&(u.normal=yr.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new H,materialIndex:0};yr.getNormal(Oc,Uc,Bc,f.normal),u.face=f,u.barycoord=h}return u}var Ys=class extends pi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Hn,u=Hn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var dl=class extends Ft{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Wo=new Je,x0=new Je,Gc=[],y0=new Pi,sM=new Je,Ka=new Tn,Qa=new $s,pl=class extends Tn{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new dl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,sM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Pi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Wo),y0.copy(e.boundingBox).applyMatrix4(Wo),this.boundingBox.union(y0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new $s),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Wo),Qa.copy(e.boundingSphere).applyMatrix4(Wo),this.boundingSphere.union(Qa)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Ka.geometry=this.geometry,Ka.material=this.material,Ka.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Qa.copy(this.boundingSphere),Qa.applyMatrix4(i),e.ray.intersectsSphere(Qa)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Wo),x0.multiplyMatrices(i,Wo),Ka.matrixWorld=x0,Ka.raycast(e,Gc);for(let o=0,a=Gc.length;o<a;o++){let l=Gc[o];l.instanceId=r,l.object=this,t.push(l)}Gc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new dl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ys(new Float32Array(s*this.count),s,this.count,Fu,Hi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},$r=new $s,rM=new Qe(.5,.5),Hc=new H,vr=class{constructor(e=new Ki,t=new Ki,i=new Ki,s=new Ki,r=new Ki,o=new Ki){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Vi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],y=r[8],v=r[9],g=r[10],x=r[11],_=r[12],M=r[13],S=r[14],T=r[15];if(s[0].setComponents(c-o,d-u,x-y,T-_).normalize(),s[1].setComponents(c+o,d+u,x+y,T+_).normalize(),s[2].setComponents(c+a,d+h,x+v,T+M).normalize(),s[3].setComponents(c-a,d-h,x-v,T-M).normalize(),i)s[4].setComponents(l,f,g,S).normalize(),s[5].setComponents(c-l,d-f,x-g,T-S).normalize();else if(s[4].setComponents(c-l,d-f,x-g,T-S).normalize(),t===Vi)s[5].setComponents(c+l,d+f,x+g,T+S).normalize();else if(t===Jo)s[5].setComponents(l,f,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),$r.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),$r.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere($r)}intersectsSprite(e){$r.center.set(0,0,0);let t=rM.distanceTo(e.center);return $r.radius=.7071067811865476+t,$r.applyMatrix4(e.matrixWorld),this.intersectsSphere($r)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Hc.x=s.normal.x>0?e.max.x:e.min.x,Hc.y=s.normal.y>0?e.max.y:e.min.y,Hc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Hc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},v0=new Je,uu=class n{constructor(){this.coordinateSystem=Vi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];v0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new vr),i[s].setFromProjectionMatrix(v0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new vr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Yr=class extends Xs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},hu=new H,fu=new H,b0=new Je,el=new na,Wc=new $s,dd=new H,S0=new H,du=class extends Yn{constructor(e=new jn,t=new Yr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)hu.fromBufferAttribute(t,s-1),fu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=hu.distanceTo(fu);e.setAttribute("lineDistance",new Pn(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Wc.copy(i.boundingSphere),Wc.applyMatrix4(s),Wc.radius+=r,e.ray.intersectsSphere(Wc)===!1)return;b0.copy(s).invert(),el.copy(e.ray).applyMatrix4(b0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),y=Math.min(u.count,o.start+o.count);for(let v=d,g=y-1;v<g;v+=c){let x=u.getX(v),_=u.getX(v+1),M=$c(this,e,el,l,x,_,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(y-1),g=u.getX(d),x=$c(this,e,el,l,v,g,y-1);x&&t.push(x)}}else{let d=Math.max(0,o.start),y=Math.min(f.count,o.start+o.count);for(let v=d,g=y-1;v<g;v+=c){let x=$c(this,e,el,l,v,v+1,v);x&&t.push(x)}if(this.isLineLoop){let v=$c(this,e,el,l,y-1,d,y-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function $c(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(hu.fromBufferAttribute(a,s),fu.fromBufferAttribute(a,r),t.distanceSqToSegment(hu,fu,dd,S0)>i)return;dd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(dd);if(!(c<e.near||c>e.far))return{distance:c,point:S0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var M0=new H,w0=new H,ia=class extends du{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)M0.fromBufferAttribute(t,s),w0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+M0.distanceTo(w0);e.setAttribute("lineDistance",new Pn(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ml=class extends pi{constructor(e=[],t=Qr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var js=class extends pi{constructor(e,t,i=ts,s,r,o,a=Hn,l=Hn,c,u=Hs,h=1){if(u!==Hs&&u!==Zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Qo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},gl=class extends js{constructor(e,t=ts,i=Qr,s,r,o=Hn,a=Hn,l,c=Hs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},_l=class extends pi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},sa=class n extends jn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;y("z","y","x",-1,-1,i,t,e,o,r,0),y("z","y","x",1,-1,i,t,-e,o,r,1),y("x","z","y",1,1,e,i,t,s,o,2),y("x","z","y",1,-1,e,i,-t,s,o,3),y("x","y","z",1,-1,e,t,i,s,r,4),y("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Pn(c,3)),this.setAttribute("normal",new Pn(u,3)),this.setAttribute("uv",new Pn(h,2));function y(v,g,x,_,M,S,T,b,m,w,R){let C=S/m,I=T/w,E=S/2,F=T/2,D=b/2,z=m+1,X=w+1,k=0,se=0,q=new H;for(let J=0;J<X;J++){let ne=J*I-F;for(let pe=0;pe<z;pe++){let te=pe*C-E;q[v]=te*_,q[g]=ne*M,q[x]=D,c.push(q.x,q.y,q.z),q[v]=0,q[g]=0,q[x]=b>0?1:-1,u.push(q.x,q.y,q.z),h.push(pe/m),h.push(1-J/w),k+=1}}for(let J=0;J<w;J++)for(let ne=0;ne<m;ne++){let pe=f+ne+z*J,te=f+ne+z*(J+1),j=f+(ne+1)+z*(J+1),he=f+(ne+1)+z*J;l.push(pe,te,he),l.push(te,j,he),se+=6}a.addGroup(d,se,R),d+=se,f+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var xl=class n extends jn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],y=[],v=[],g=[];for(let x=0;x<u;x++){let _=x*f-o;for(let M=0;M<c;M++){let S=M*h-r;y.push(S,-_,0),v.push(0,0,1),g.push(M/a),g.push(1-x/l)}}for(let x=0;x<l;x++)for(let _=0;_<a;_++){let M=_+c*x,S=_+c*(x+1),T=_+1+c*(x+1),b=_+1+c*x;d.push(M,S,b),d.push(S,T,b)}this.setIndex(d),this.setAttribute("position",new Pn(y,3)),this.setAttribute("normal",new Pn(v,3)),this.setAttribute("uv",new Pn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var br=class n extends jn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,f=new H,d=[],y=[],v=[],g=[];for(let x=0;x<=i;x++){let _=[],M=x/i,S=o+M*a,T=e*Math.cos(S),b=Math.sqrt(e*e-T*T),m=0;x===0&&o===0?m=.5/t:x===i&&l===Math.PI&&(m=-.5/t);for(let w=0;w<=t;w++){let R=w/t,C=s+R*r;h.x=-b*Math.cos(C),h.y=T,h.z=b*Math.sin(C),y.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),g.push(R+m,1-M),_.push(c++)}u.push(_)}for(let x=0;x<i;x++)for(let _=0;_<t;_++){let M=u[x][_+1],S=u[x][_],T=u[x+1][_],b=u[x+1][_+1];(x!==0||o>0)&&d.push(M,S,b),(x!==i-1||l<Math.PI)&&d.push(S,T,b)}this.setIndex(d),this.setAttribute("position",new Pn(y,3)),this.setAttribute("normal",new Pn(v,3)),this.setAttribute("uv",new Pn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function to(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(T0(s))s.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(T0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ii(n){let e={};for(let t=0;t<n.length;t++){let i=to(n[t]);for(let s in i)e[s]=i[s]}return e}function T0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function oM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Qd(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var b_={clone:to,merge:ii},aM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,lM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Gi=class extends Xs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=aM,this.fragmentShader=lM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=to(e.uniforms),this.uniformsGroups=oM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new rt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Qe().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Wt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Je().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},pu=class extends Gi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yl=class extends Xs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new rt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=mh,this.normalScale=new Qe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ws,this.combine=Cu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},mu=class extends Xs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=r_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},gu=class extends Xs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function $o(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Xc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Sr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},_u=class extends Sr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gd,endingEnd:gd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _d:r=e,a=2*t-i;break;case xd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case _d:o=e,l=2*i-t;break;case xd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,y=(i-t)/(s-t),v=y*y,g=v*y,x=-f*g+2*f*v-f*y,_=(1+f)*g+(-1.5-2*f)*v+(-.5+f)*y+1,M=(-1-d)*g+(1.5+d)*v+.5*y,S=d*g-d*v;for(let T=0;T!==a;++T)r[T]=x*o[u+T]+_*o[c+T]+M*o[l+T]+S*o[h+T];return r}},xu=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},yu=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},vu=class extends Sr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let y=(i-t)/(s-t),v=1-y;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*y;return r}let f=a*2,d=e-1;for(let y=0;y!==a;++y){let v=o[c+y],g=o[l+y],x=d*f+y*2,_=h[x],M=h[x+1],S=e*f+y*2,T=u[S],b=u[S+1],m=uM(i,t,_,T,s);r[y]=S_(m,v,M,b,g)}return r}};function S_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function cM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function uM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=S_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=cM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ii=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=$o(t,this.TimeBufferType),this.values=$o(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:$o(e.times,Array),values:$o(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Xc(e.settings)&&(i.settings={inTangents:$o(e.settings.inTangents,Array),outTangents:$o(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new yu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new xu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new _u(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new vu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case sl:t=this.InterpolantFactoryMethodDiscrete;break;case ou:t=this.InterpolantFactoryMethodLinear;break;case jc:t=this.InterpolantFactoryMethodSmooth;break;case md:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sl;case this.InterpolantFactoryMethodLinear:return ou;case this.InterpolantFactoryMethodSmooth:return jc;case this.InterpolantFactoryMethodBezier:return md}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Xc(this.settings)&&(A0(this.settings.inTangents,e),A0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Xc(this.settings)&&(E0(this.settings.inTangents,e),E0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&TS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===jc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let y=0;y!==i;++y){let v=t[h+y];if(v!==t[f+y]||v!==t[d+y]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Xc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function A0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function E0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ii.prototype.ValueTypeName="";Ii.prototype.TimeBufferType=Float32Array;Ii.prototype.ValueBufferType=Float32Array;Ii.prototype.DefaultInterpolation=ou;var Mr=class extends Ii{constructor(e,t,i){super(e,t,i)}};Mr.prototype.ValueTypeName="bool";Mr.prototype.ValueBufferType=Array;Mr.prototype.DefaultInterpolation=sl;Mr.prototype.InterpolantFactoryMethodLinear=void 0;Mr.prototype.InterpolantFactoryMethodSmooth=void 0;var bu=class extends Ii{constructor(e,t,i,s){super(e,t,i,s)}};bu.prototype.ValueTypeName="color";var Su=class extends Ii{constructor(e,t,i,s){super(e,t,i,s)}};Su.prototype.ValueTypeName="number";var Mu=class extends Sr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)fn.slerpFlat(r,0,o,c-a,o,c,l);return r}},vl=class extends Ii{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Mu(this.times,this.values,this.getValueSize(),e)}};vl.prototype.ValueTypeName="quaternion";vl.prototype.InterpolantFactoryMethodSmooth=void 0;var wr=class extends Ii{constructor(e,t,i){super(e,t,i)}};wr.prototype.ValueTypeName="string";wr.prototype.ValueBufferType=Array;wr.prototype.DefaultInterpolation=sl;wr.prototype.InterpolantFactoryMethodLinear=void 0;wr.prototype.InterpolantFactoryMethodSmooth=void 0;var wu=class extends Ii{constructor(e,t,i,s){super(e,t,i,s)}};wu.prototype.ValueTypeName="vector";var yd={enabled:!1,files:{},add:function(n,e){this.enabled!==!1&&(C0(n)||(this.files[n]=e))},get:function(n){if(this.enabled!==!1&&!C0(n))return this.files[n]},remove:function(n){delete this.files[n]},clear:function(){this.files={}}};function C0(n){try{let e=n.slice(n.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Tu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],y=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return y}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},M_=new Tu,jr=class{constructor(e){this.manager=e!==void 0?e:M_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Vs={},vd=class extends Error{constructor(e,t){super(e),this.response=t}},bl=class extends jr{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,i,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=yd.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Vs[e]!==void 0){Vs[e].push({onLoad:t,onProgress:i,onError:s});return}Vs[e]=[],Vs[e].push({onLoad:t,onProgress:i,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&je("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Vs[e],h=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),d=f?parseInt(f):0,y=d!==0,v=0,g=new ReadableStream({start(x){_();function _(){h.read().then(({done:M,value:S})=>{if(M)x.close();else{v+=S.byteLength;let T=new ProgressEvent("progress",{lengthComputable:y,loaded:v,total:d});for(let b=0,m=u.length;b<m;b++){let w=u[b];w.onProgress&&w.onProgress(T)}x.enqueue(S),_()}},M=>{x.error(M)})}}});return new Response(g)}else throw new vd(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),f=h&&h[1]?h[1].toLowerCase():void 0,d=new TextDecoder(f);return c.arrayBuffer().then(y=>d.decode(y))}}}).then(c=>{yd.add(`file:${e}`,c);let u=Vs[e];delete Vs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onLoad&&d.onLoad(c)}}).catch(c=>{let u=Vs[e];if(u===void 0)throw this.manager.itemError(e),c;delete Vs[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onError&&d.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Sl=class extends Yn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new rt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ml=class extends Sl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Yn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new rt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},pd=new Je,R0=new H,P0=new H,Au=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Qe(512,512),this.mapType=gi,this.map=null,this.mapPass=null,this.matrix=new Je,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new vr,this._frameExtents=new Qe(1,1),this._viewportCount=1,this._viewports=[new Wt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;R0.setFromMatrixPosition(e.matrixWorld),t.position.copy(R0),P0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(P0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){pd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(pd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Jo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(pd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},qc=new H,Yc=new fn,ys=new H,wl=class extends Yn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Je,this.projectionMatrix=new Je,this.projectionMatrixInverse=new Je,this.coordinateSystem=Vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(qc,Yc,ys),ys.x===1&&ys.y===1&&ys.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qc,Yc,ys.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(qc,Yc,ys),ys.x===1&&ys.y===1&&ys.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qc,Yc,ys.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},xr=new H,I0=new Qe,L0=new Qe,Ci=class extends wl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ko*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(nl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ko*2*Math.atan(Math.tan(nl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){xr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(xr.x,xr.y).multiplyScalar(-e/xr.z),xr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(xr.x,xr.y).multiplyScalar(-e/xr.z)}getViewSize(e,t){return this.getViewBounds(e,I0,L0),t.subVectors(L0,I0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(nl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Li=class extends wl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},bd=class extends Au{constructor(){super(new Li(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Tl=class extends Sl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Yn.DEFAULT_UP),this.updateMatrix(),this.target=new Yn,this.shadow=new bd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Xo=-90,qo=1,ra=class extends Yn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ci(Xo,qo,e,t);s.layers=this.layers,this.add(s);let r=new Ci(Xo,qo,e,t);r.layers=this.layers,this.add(r);let o=new Ci(Xo,qo,e,t);o.layers=this.layers,this.add(o);let a=new Ci(Xo,qo,e,t);a.layers=this.layers,this.add(a);let l=new Ci(Xo,qo,e,t);l.layers=this.layers,this.add(l);let c=new Ci(Xo,qo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Jo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),y=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=y,i.texture.needsPMREMUpdate=!0}},Eu=class extends Ci{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ep="\\[\\]\\.:\\/",hM=new RegExp("["+ep+"]","g"),tp="[^"+ep+"]",fM="[^"+ep.replace("\\.","")+"]",dM=/((?:WC+[\/:])*)/.source.replace("WC",tp),pM=/(WCOD+)?/.source.replace("WCOD",fM),mM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tp),gM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tp),_M=new RegExp("^"+dM+pM+mM+gM+"$"),xM=["material","materials","bones","map"],Sd=class{constructor(e,t,i){let s=i||en.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},en=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(hM,"")}static parseTrackName(e){let t=_M.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);xM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};en.Composite=Sd;en.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};en.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};en.prototype.GetterByBindingType=[en.prototype._getValue_direct,en.prototype._getValue_array,en.prototype._getValue_arrayElement,en.prototype._getValue_toArray];en.prototype.SetterByBindingTypeAndVersioning=[[en.prototype._setValue_direct,en.prototype._setValue_direct_setNeedsUpdate,en.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[en.prototype._setValue_array,en.prototype._setValue_array_setNeedsUpdate,en.prototype._setValue_array_setMatrixWorldNeedsUpdate],[en.prototype._setValue_arrayElement,en.prototype._setValue_arrayElement_setNeedsUpdate,en.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[en.prototype._setValue_fromArray,en.prototype._setValue_fromArray_setNeedsUpdate,en.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var H3=new Float32Array(1);var N0=new Je,Jr=class{constructor(e,t,i=0,s=1/0){this.ray=new na(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ea,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return N0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(N0),this}intersectObject(e,t=!0,i=[]){return Md(e,this,i,t),i.sort(D0),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Md(e[s],this,i,t);return i.sort(D0),i}};function D0(n,e){return n.distance-e.distance}function Md(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Md(r[o],e,t,!0)}}var wd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Al=class extends Qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function np(n,e,t,i){let s=yM(i);switch(t){case Hd:return n*e;case Fu:return n*e/s.components*s.byteLength;case Ou:return n*e/s.components*s.byteLength;case Er:return n*e*2/s.components*s.byteLength;case Uu:return n*e*2/s.components*s.byteLength;case Wd:return n*e*3/s.components*s.byteLength;case is:return n*e*4/s.components*s.byteLength;case Bu:return n*e*4/s.components*s.byteLength;case Rl:case Pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Il:case Ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case zu:case Gu:return Math.max(n,16)*Math.max(e,8)/4;case ku:case Vu:return Math.max(n,8)*Math.max(e,8)/2;case Hu:case Wu:case Xu:case qu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case $u:case Nl:case Yu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ju:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ju:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Zu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ku:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Qu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case eh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case th:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case nh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case ih:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case sh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case rh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case oh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case ah:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case lh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case ch:case uh:case hh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case fh:case dh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Dl:case ph:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function yM(n){switch(n){case gi:case kd:return{byteLength:1,components:1};case ca:case zd:case ns:return{byteLength:2,components:1};case Nu:case Du:return{byteLength:2,components:4};case ts:case Lu:case Hi:return{byteLength:4,components:1};case Vd:case Gd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function $_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function bM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,y)=>d.start-y.start);let f=0;for(let d=1;d<h.length;d++){let y=h[f],v=h[d];v.start<=y.start+y.count+1?y.count=Math.max(y.count,v.start+v.count-y.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,y=h.length;d<y;d++){let v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var SM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,MM=`#ifdef USE_ALPHAHASH
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
#endif`,wM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,TM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,AM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,EM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,CM=`#ifdef USE_AOMAP
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
#endif`,RM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,PM=`#ifdef USE_BATCHING
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
#endif`,IM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,LM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,NM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,FM=`#ifdef USE_IRIDESCENCE
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
#endif`,OM=`#ifdef USE_BUMPMAP
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
#endif`,UM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,BM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,VM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,GM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,HM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,WM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,$M=`#define PI 3.141592653589793
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
} // validated`,XM=`vec3 transformedNormal = objectNormal;
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
#endif`,qM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,YM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,jM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,JM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ZM="gl_FragColor = linearToOutputTexel( gl_FragColor );",KM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,QM=`#ifdef USE_ENVMAP
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
#endif`,ew=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tw=`#ifdef USE_ENVMAP
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
#endif`,nw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iw=`#ifdef USE_ENVMAP
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
#endif`,sw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ow=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lw=`#ifdef USE_GRADIENTMAP
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
}`,cw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,uw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,fw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,dw=`#ifdef USE_ENVMAP
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
#endif`,pw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_w=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xw=`PhysicalMaterial material;
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
#endif`,yw=`uniform sampler2D dfgLUT;
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
}`,vw=`
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
#endif`,bw=`#if defined( RE_IndirectDiffuse )
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
#endif`,Sw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Mw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ww=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Tw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Aw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ew=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Cw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Pw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Iw=`#if defined( USE_POINTS_UV )
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
#endif`,Lw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Nw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Dw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Fw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Ow=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Uw=`#ifdef USE_MORPHTARGETS
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
#endif`,Bw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,zw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Vw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Ww=`#ifdef USE_NORMALMAP
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
#endif`,$w=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Xw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Yw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,jw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Jw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Zw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Qw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,e1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,t1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,n1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,i1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,s1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,r1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,o1=`float getShadowMask() {
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
}`,a1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,l1=`#ifdef USE_SKINNING
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
#endif`,c1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,u1=`#ifdef USE_SKINNING
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
#endif`,h1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,f1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,d1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,p1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,m1=`#ifdef USE_TRANSMISSION
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
#endif`,g1=`#ifdef USE_TRANSMISSION
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
#endif`,_1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,x1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,y1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,v1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,b1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,S1=`uniform sampler2D t2D;
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
}`,M1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,w1=`uniform float backgroundBlurriness;
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
}`,T1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,A1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,E1=`#include <common>
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
}`,C1=`#if DEPTH_PACKING == 3200
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
}`,R1=`#define DISTANCE
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
}`,P1=`#define DISTANCE
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
}`,I1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,L1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,N1=`uniform float scale;
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
}`,D1=`uniform vec3 diffuse;
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
}`,F1=`#include <common>
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
}`,O1=`uniform vec3 diffuse;
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
}`,U1=`#define LAMBERT
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
}`,B1=`#define LAMBERT
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
}`,k1=`#define MATCAP
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
}`,z1=`#define MATCAP
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
}`,V1=`#define NORMAL
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
}`,G1=`#define NORMAL
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
}`,H1=`#define PHONG
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
}`,W1=`#define PHONG
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
}`,$1=`#define STANDARD
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
}`,X1=`#define STANDARD
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
}`,q1=`#define TOON
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
}`,Y1=`#define TOON
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
}`,j1=`uniform float size;
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
}`,J1=`uniform vec3 diffuse;
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
}`,Z1=`#include <common>
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
}`,K1=`uniform vec3 color;
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
}`,Q1=`uniform float rotation;
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
}`,eT=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:SM,alphahash_pars_fragment:MM,alphamap_fragment:wM,alphamap_pars_fragment:TM,alphatest_fragment:AM,alphatest_pars_fragment:EM,aomap_fragment:CM,aomap_pars_fragment:RM,batching_pars_vertex:PM,batching_vertex:IM,begin_vertex:LM,beginnormal_vertex:NM,bsdfs:DM,iridescence_fragment:FM,bumpmap_pars_fragment:OM,clipping_planes_fragment:UM,clipping_planes_pars_fragment:BM,clipping_planes_pars_vertex:kM,clipping_planes_vertex:zM,color_fragment:VM,color_pars_fragment:GM,color_pars_vertex:HM,color_vertex:WM,common:$M,defaultnormal_vertex:XM,displacementmap_pars_vertex:qM,displacementmap_vertex:YM,emissivemap_fragment:jM,emissivemap_pars_fragment:JM,colorspace_fragment:ZM,colorspace_pars_fragment:KM,envmap_fragment:QM,envmap_common_pars_fragment:ew,envmap_pars_fragment:tw,envmap_pars_vertex:nw,envmap_physical_pars_fragment:dw,envmap_vertex:iw,fog_vertex:sw,fog_pars_vertex:rw,fog_fragment:ow,fog_pars_fragment:aw,gradientmap_pars_fragment:lw,lightmap_pars_fragment:cw,lights_lambert_fragment:uw,lights_lambert_pars_fragment:hw,lights_pars_begin:fw,lights_toon_fragment:pw,lights_toon_pars_fragment:mw,lights_phong_fragment:gw,lights_phong_pars_fragment:_w,lights_physical_fragment:xw,lights_physical_pars_fragment:yw,lights_fragment_begin:vw,lights_fragment_maps:bw,lights_fragment_end:Sw,lightprobes_pars_fragment:Mw,logdepthbuf_fragment:ww,logdepthbuf_pars_fragment:Tw,logdepthbuf_pars_vertex:Aw,logdepthbuf_vertex:Ew,map_fragment:Cw,map_pars_fragment:Rw,map_particle_fragment:Pw,map_particle_pars_fragment:Iw,metalnessmap_fragment:Lw,metalnessmap_pars_fragment:Nw,morphinstance_vertex:Dw,morphcolor_vertex:Fw,morphnormal_vertex:Ow,morphtarget_pars_vertex:Uw,morphtarget_vertex:Bw,normal_fragment_begin:kw,normal_fragment_maps:zw,normal_pars_fragment:Vw,normal_pars_vertex:Gw,normal_vertex:Hw,normalmap_pars_fragment:Ww,clearcoat_normal_fragment_begin:$w,clearcoat_normal_fragment_maps:Xw,clearcoat_pars_fragment:qw,iridescence_pars_fragment:Yw,opaque_fragment:jw,packing:Jw,premultiplied_alpha_fragment:Zw,project_vertex:Kw,dithering_fragment:Qw,dithering_pars_fragment:e1,roughnessmap_fragment:t1,roughnessmap_pars_fragment:n1,shadowmap_pars_fragment:i1,shadowmap_pars_vertex:s1,shadowmap_vertex:r1,shadowmask_pars_fragment:o1,skinbase_vertex:a1,skinning_pars_vertex:l1,skinning_vertex:c1,skinnormal_vertex:u1,specularmap_fragment:h1,specularmap_pars_fragment:f1,tonemapping_fragment:d1,tonemapping_pars_fragment:p1,transmission_fragment:m1,transmission_pars_fragment:g1,uv_pars_fragment:_1,uv_pars_vertex:x1,uv_vertex:y1,worldpos_vertex:v1,background_vert:b1,background_frag:S1,backgroundCube_vert:M1,backgroundCube_frag:w1,cube_vert:T1,cube_frag:A1,depth_vert:E1,depth_frag:C1,distance_vert:R1,distance_frag:P1,equirect_vert:I1,equirect_frag:L1,linedashed_vert:N1,linedashed_frag:D1,meshbasic_vert:F1,meshbasic_frag:O1,meshlambert_vert:U1,meshlambert_frag:B1,meshmatcap_vert:k1,meshmatcap_frag:z1,meshnormal_vert:V1,meshnormal_frag:G1,meshphong_vert:H1,meshphong_frag:W1,meshphysical_vert:$1,meshphysical_frag:X1,meshtoon_vert:q1,meshtoon_frag:Y1,points_vert:j1,points_frag:J1,shadow_vert:Z1,shadow_frag:K1,sprite_vert:Q1,sprite_frag:eT},Fe={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new Qe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new Qe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ws={basic:{uniforms:ii([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:ii([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:ii([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:ii([Fe.common,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.roughnessmap,Fe.metalnessmap,Fe.fog,Fe.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:ii([Fe.common,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.gradientmap,Fe.fog,Fe.lights,{emissive:{value:new rt(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:ii([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:ii([Fe.points,Fe.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:ii([Fe.common,Fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:ii([Fe.common,Fe.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:ii([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:ii([Fe.sprite,Fe.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:ii([Fe.common,Fe.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:ii([Fe.lights,Fe.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};ws.physical={uniforms:ii([ws.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new Qe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new Qe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new Qe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var _h={r:0,b:0,g:0},tT=new Je,X_=new it;X_.set(-1,0,0,0,1,0,0,0,1);function nT(n,e,t,i,s,r){let o=new rt(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let S=_.backgroundBlurriness>0;M=e.get(M,S)}return M}function y(_){let M=!1,S=d(_);S===null?g(o,a):S&&S.isColor&&(g(S,1),M=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(_,M){let S=d(M);S&&S.isCubeTexture?(c===void 0&&(c=new Tn(new sa(1,1,1),new Gi({name:"BackgroundCubeMaterial",uniforms:to(ws.backgroundCube.uniforms),vertexShader:ws.backgroundCube.vertexShader,fragmentShader:ws.backgroundCube.fragmentShader,side:fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,b,m){this.matrixWorld.copyPosition(m.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(tT.makeRotationFromEuler(M.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(X_),c.material.toneMapped=bt.getTransfer(S.colorSpace)!==Dt,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Tn(new xl(2,2),new Gi({name:"BackgroundMaterial",uniforms:to(ws.background.uniforms),vertexShader:ws.background.vertexShader,fragmentShader:ws.background.fragmentShader,side:Ar,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=bt.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,M){_.getRGB(_h,Qd(n)),t.buffers.color.setClear(_h.r,_h.g,_h.b,M,r)}function x(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:y,addToRenderList:v,dispose:x}}function iT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(I,E,F,D,z){let X=!1,k=h(I,D,F,E);r!==k&&(r=k,c(r.object)),X=d(I,D,F,z),X&&y(I,D,F,z),z!==null&&e.update(z,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,S(I,E,F,D),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(z).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,E,F,D){let z=D.wireframe===!0,X=i[E.id];X===void 0&&(X={},i[E.id]=X);let k=I.isInstancedMesh===!0?I.id:0,se=X[k];se===void 0&&(se={},X[k]=se);let q=se[F.id];q===void 0&&(q={},se[F.id]=q);let J=q[z];return J===void 0&&(J=f(l()),q[z]=J),J}function f(I){let E=[],F=[],D=[];for(let z=0;z<t;z++)E[z]=0,F[z]=0,D[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:E,enabledAttributes:F,attributeDivisors:D,object:I,attributes:{},index:null}}function d(I,E,F,D){let z=r.attributes,X=E.attributes,k=0,se=F.getAttributes();for(let q in se)if(se[q].location>=0){let ne=z[q],pe=X[q];if(pe===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(pe=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(pe=I.instanceColor)),ne===void 0||ne.attribute!==pe||pe&&ne.data!==pe.data)return!0;k++}return r.attributesNum!==k||r.index!==D}function y(I,E,F,D){let z={},X=E.attributes,k=0,se=F.getAttributes();for(let q in se)if(se[q].location>=0){let ne=X[q];ne===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(ne=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(ne=I.instanceColor));let pe={};pe.attribute=ne,ne&&ne.data&&(pe.data=ne.data),z[q]=pe,k++}r.attributes=z,r.attributesNum=k,r.index=D}function v(){let I=r.newAttributes;for(let E=0,F=I.length;E<F;E++)I[E]=0}function g(I){x(I,0)}function x(I,E){let F=r.newAttributes,D=r.enabledAttributes,z=r.attributeDivisors;F[I]=1,D[I]===0&&(n.enableVertexAttribArray(I),D[I]=1),z[I]!==E&&(n.vertexAttribDivisor(I,E),z[I]=E)}function _(){let I=r.newAttributes,E=r.enabledAttributes;for(let F=0,D=E.length;F<D;F++)E[F]!==I[F]&&(n.disableVertexAttribArray(F),E[F]=0)}function M(I,E,F,D,z,X,k){k===!0?n.vertexAttribIPointer(I,E,F,z,X):n.vertexAttribPointer(I,E,F,D,z,X)}function S(I,E,F,D){v();let z=D.attributes,X=F.getAttributes(),k=E.defaultAttributeValues;for(let se in X){let q=X[se];if(q.location>=0){let J=z[se];if(J===void 0&&(se==="instanceMatrix"&&I.instanceMatrix&&(J=I.instanceMatrix),se==="instanceColor"&&I.instanceColor&&(J=I.instanceColor)),J!==void 0){let ne=J.normalized,pe=J.itemSize,te=e.get(J);if(te===void 0)continue;let j=te.buffer,he=te.type,me=te.bytesPerElement,Q=he===n.INT||he===n.UNSIGNED_INT||J.gpuType===Lu;if(J.isInterleavedBufferAttribute){let ue=J.data,Me=ue.isInterleavedBuffer===!0?ue.stride:ue.itemSize,We=J.offset;if(ue.isInstancedInterleavedBuffer||ue.isInstancedBufferAttribute){for(let Ge=0;Ge<q.locationSize;Ge++)x(q.location+Ge,ue.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ue.meshPerAttribute*ue.count)}else for(let Ge=0;Ge<q.locationSize;Ge++)g(q.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Ge=0;Ge<q.locationSize;Ge++)M(q.location+Ge,pe/q.locationSize,he,ne,Me*me,(We+pe/q.locationSize*Ge)*me,Q)}else{if(J.isInstancedBufferAttribute){for(let ue=0;ue<q.locationSize;ue++)x(q.location+ue,J.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let ue=0;ue<q.locationSize;ue++)g(q.location+ue);n.bindBuffer(n.ARRAY_BUFFER,j);for(let ue=0;ue<q.locationSize;ue++)M(q.location+ue,pe/q.locationSize,he,ne,pe*me,pe/q.locationSize*ue*me,Q)}}else if(k!==void 0){let ne=k[se];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv(q.location,ne);break;case 3:n.vertexAttrib3fv(q.location,ne);break;case 4:n.vertexAttrib4fv(q.location,ne);break;default:n.vertexAttrib1fv(q.location,ne)}}}}_()}function T(){R();for(let I in i){let E=i[I];for(let F in E){let D=E[F];for(let z in D){let X=D[z];for(let k in X)u(X[k].object),delete X[k];delete D[z]}}delete i[I]}}function b(I){if(i[I.id]===void 0)return;let E=i[I.id];for(let F in E){let D=E[F];for(let z in D){let X=D[z];for(let k in X)u(X[k].object),delete X[k];delete D[z]}}delete i[I.id]}function m(I){for(let E in i){let F=i[E];for(let D in F){let z=F[D];if(z[I.id]===void 0)continue;let X=z[I.id];for(let k in X)u(X[k].object),delete X[k];delete z[I.id]}}}function w(I){for(let E in i){let F=i[E],D=I.isInstancedMesh===!0?I.id:0,z=F[D];if(z!==void 0){for(let X in z){let k=z[X];for(let se in k)u(k[se].object),delete k[se];delete z[X]}delete F[D],Object.keys(F).length===0&&delete i[E]}}}function R(){C(),o=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:R,resetDefaultState:C,dispose:T,releaseStatesOfGeometry:b,releaseStatesOfObject:w,releaseStatesOfProgram:m,initAttributes:v,enableAttribute:g,disableUnusedAttributes:_}}function sT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function rT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let m=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(m.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(m){return!(m!==is&&i.convert(m)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(m){let w=m===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(m!==gi&&m!==Hi&&!w&&i.convert(m)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(m){if(m==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";m="mediump"}return m==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),x=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),b=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:y,maxTextureSize:v,maxCubemapSize:g,maxAttributes:x,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:S,maxSamples:T,samples:b}}function oT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Ki,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let y=h.clippingPlanes,v=h.clipIntersection,g=h.clipShadows,x=n.get(h);if(!s||y===null||y.length===0||r&&!g)r?u(null):c();else{let _=r?0:i,M=_*4,S=x.clippingState||null;l.value=S,S=u(y,f,M,d);for(let T=0;T!==M;++T)S[T]=t[T];x.clippingState=S,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,y){let v=h!==null?h.length:0,g=null;if(v!==0){if(g=l.value,y!==!0||g===null){let x=d+v*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<x)&&(g=new Float32Array(x));for(let M=0,S=d;M!==v;++M,S+=4)o.copy(h[M]).applyMatrix4(_,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var Ul=class extends Ri{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ml(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new sa(5,5,5),r=new Gi({name:"CubemapFromEquirect",uniforms:to(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:fi,blending:Zr});r.uniforms.tEquirect.value=t;let o=new Tn(s,r),a=t.minFilter;return t.minFilter===Js&&(t.minFilter=hi),new ra(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},w_=256,aT=3,lT=20,q_=256,Y_=16,cT=3,uT=new H,hT=new rt,yh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ra(1,10,null),this._boxMesh=new Tn(new sa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=uT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,y=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(hT));let g=new ra(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=y,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=E_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=A_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(w_,Zd(e))}_fromTexture(e,t){e.mapping===Qr||e.mapping===la?this._setSize(e.image.length===0?w_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=T_(e,!1,!1),i=Math.log2(e)-aT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=T_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Qr||e.mapping===la?(this._cubemapMaterial===null&&(this._cubemapMaterial=E_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=A_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=fT(),this._integrationMaterial=dT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Y_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-cT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(q_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=pT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function T_(n,e,t){return new Ul(n,{minFilter:Js,generateMipmaps:e,type:ns,colorSpace:rl,depthBuffer:t})}function Bl(n,e,t){return new Gi({name:n,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:fi,blending:Zr,depthTest:!1,depthWrite:!1})}function fT(){return Bl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${q_}u

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
	`)}function dT(){return Bl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Y_}},`

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
	`)}function pT(){return Bl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${lT}
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
	`)}function A_(){return Bl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function E_(){return Bl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function mT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Ru||d===Pu)if(e.has(f)){let y=e.get(f).texture;return a(y,f.mapping)}else{let y=f.image;if(y&&y.height>0){let v=new Ul(y.height);return v.fromEquirectangularTexture(n,f),e.set(f,v),f.addEventListener("dispose",c),a(v.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,y=d===Ru||d===Pu,v=d===Qr||d===la;if(y||v){let g=t.get(f),x=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==x)return i===null&&(i=new yh(n)),g=y?i.fromEquirectangular(f,g):i.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let _=f.image;return y&&_&&_.height>0||v&&_&&l(_)?(i===null&&(i=new yh(n)),g=y?i.fromEquirectangular(f):i.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===Ru?f.mapping=Qr:d===Pu&&(f.mapping=la),f}function l(f){let d=0,y=6;for(let v=0;v<y;v++)f[v]!==void 0&&d++;return d===y}function c(f){let d=f.target;d.removeEventListener("dispose",c);let y=e.get(d);y!==void 0&&(e.delete(d),y.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let y=t.get(d);y!==void 0&&(t.delete(d),y.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function gT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&tl("WebGLRenderer: "+i+" extension not supported."),s}}}function _T(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(y=>delete s[y]);function a(y){l(y.target)}function l(y){y.index!==null&&e.remove(y.index);for(let g in y.attributes)e.remove(y.attributes[g]);y.removeEventListener("dispose",a),delete s[y.id],o.unregister(y);let v=r.get(y);v&&(e.remove(v),r.delete(y)),i.releaseStatesOfGeometry(y),y.isInstancedBufferGeometry===!0&&delete y._maxInstanceCount,t.memory.geometries--}function c(y,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(y){let v=y.attributes;for(let g in v)e.update(v[g],n.ARRAY_BUFFER)}function h(y){let v=y.index,g=y.attributes.position,x=0;if(g===void 0)return;let _=v!==null?v.array.length:g.array.length/3-1,M=g.count>=65535?qr:Xr,S=new M(Math.ceil(_/3)*6,1),T=S.array;if(v!==null){let m=v.array;x=v.version;for(let w=0,R=0;w<_;w+=3){let C=m[w+0],I=m[w+1],E=m[w+2];T[R++]=C,T[R++]=I,T[R++]=I,T[R++]=E,T[R++]=E,T[R++]=C}}else{x=g.version;for(let m=0,w=0;m<_;m+=3){let R=m+0,C=m+1,I=m+2;T[w++]=R,T[w++]=C,T[w++]=C,T[w++]=I,T[w++]=I,T[w++]=R}}S.version=x;let b=r.get(y);b&&e.remove(b),r.set(y,S)}function f(y){let v=r.get(y);if(v){let g=y.index;g!==null&&v.version<g.version&&h(y)}else h(y);return r.get(y)}function d(){for(let y in s){let v=s[y].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function xT(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let v=0;for(let g=0;g<d;g++)v+=f[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function yT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function vT(n,e,t){let i=new WeakMap,s=new Wt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let R=function(){m.dispose(),i.delete(a),a.removeEventListener("dispose",R)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,y=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;d===!0&&(M=1),y===!0&&(M=2),v===!0&&(M=3);let S=a.attributes.position.count*M,T=1;S>e.maxTextureSize&&(T=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let b=new Float32Array(S*T*4*h),m=new ll(b,S,T,h);m.type=Hi,m.needsUpdate=!0;let w=M*4;for(let C=0;C<h;C++){let I=g[C],E=x[C],F=_[C],D=S*T*4*C;for(let z=0;z<I.count;z++){let X=z*w;d===!0&&(s.fromBufferAttribute(I,z),b[D+X+0]=s.x,b[D+X+1]=s.y,b[D+X+2]=s.z,b[D+X+3]=0),y===!0&&(s.fromBufferAttribute(E,z),b[D+X+4]=s.x,b[D+X+5]=s.y,b[D+X+6]=s.z,b[D+X+7]=0),v===!0&&(s.fromBufferAttribute(F,z),b[D+X+8]=s.x,b[D+X+9]=s.y,b[D+X+10]=s.z,b[D+X+11]=F.itemSize===4?s.w:1)}}f={count:h,texture:m,size:new Qe(S,T)},i.set(a,f),a.addEventListener("dispose",R)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let y=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",y),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function bT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ST={[Id]:"LINEAR_TONE_MAPPING",[Ld]:"REINHARD_TONE_MAPPING",[Nd]:"CINEON_TONE_MAPPING",[Dd]:"ACES_FILMIC_TONE_MAPPING",[Od]:"AGX_TONE_MAPPING",[Ud]:"NEUTRAL_TONE_MAPPING",[Fd]:"CUSTOM_TONE_MAPPING"};function MT(n,e,t,i,s,r){let o=new Ri(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new jn;u.setAttribute("position",new Pn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Pn([0,2,0,0,2,0],2));let h=new pu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Tn(u,h),d=new Li(-1,1,1,-1,0,1),y=null,v=null,g=!1,x,_=null,M=[],S=!1;this.setSize=function(T,b){o.setSize(T,b),a!==null&&a.setSize(T,b),l!==null&&l.setSize(T,b);for(let m=0;m<M.length;m++){let w=M[m];w.setSize&&w.setSize(T,b)}},this.setEffects=function(T){M=T,S=M.length>0&&M[0].isRenderPass===!0;let b=o.width,m=o.height;M.length>0&&a===null&&(a=new Ri(b,m,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(b,m,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(R=>R.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new js(b,m),r===!0&&(c.format=Zs,c.type=eo)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let R=0;R<M.length;R++){let C=M[R];C.setSize&&C.setSize(b,m),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(T,b){if(g||T.toneMapping===Ss&&M.length===0)return!1;if(_=b,b!==null){let m=b.width,w=b.height;(o.width!==m||o.height!==w)&&this.setSize(m,w)}return S===!1&&T.setRenderTarget(o),x=T.toneMapping,T.toneMapping=Ss,!0},this.hasRenderPass=function(){return S},this.end=function(T,b){T.toneMapping=x,g=!0;let m=o,w=a;for(let R=0;R<M.length;R++){let C=M[R];C.enabled!==!1&&(C.render(T,w,m,b),C.needsSwap!==!1&&(m=w,w=w===a?l:a))}if(y!==T.outputColorSpace||v!==T.toneMapping){y=T.outputColorSpace,v=T.toneMapping,h.defines={},bt.getTransfer(y)===Dt&&(h.defines.SRGB_TRANSFER="");let R=ST[v];R&&(h.defines[R]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=m.texture,T.setRenderTarget(_),T.render(f,d),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var j_=new pi,J_=new js(1,1),Z_=new gl(1),K_=new ll,Q_=new cu,ex=new ml,C_=[],R_=[],P_=new Float32Array(16),I_=new Float32Array(9),L_=new Float32Array(4);function fa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=C_[s];if(r===void 0&&(r=new Float32Array(s),C_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function In(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Ln(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function vh(n,e){let t=R_[e];t===void 0&&(t=new Int32Array(e),R_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function wT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function TT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2fv(this.addr,e),Ln(t,e)}}function AT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(In(t,e))return;n.uniform3fv(this.addr,e),Ln(t,e)}}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4fv(this.addr,e),Ln(t,e)}}function CT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;L_.set(i),n.uniformMatrix2fv(this.addr,!1,L_),Ln(t,i)}}function RT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;I_.set(i),n.uniformMatrix3fv(this.addr,!1,I_),Ln(t,i)}}function PT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(In(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Ln(t,e)}else{if(In(t,i))return;P_.set(i),n.uniformMatrix4fv(this.addr,!1,P_),Ln(t,i)}}function IT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function LT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2iv(this.addr,e),Ln(t,e)}}function NT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(In(t,e))return;n.uniform3iv(this.addr,e),Ln(t,e)}}function DT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4iv(this.addr,e),Ln(t,e)}}function FT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function OT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(In(t,e))return;n.uniform2uiv(this.addr,e),Ln(t,e)}}function UT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(In(t,e))return;n.uniform3uiv(this.addr,e),Ln(t,e)}}function BT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(In(t,e))return;n.uniform4uiv(this.addr,e),Ln(t,e)}}function bh(n){return n.version===0&&(n.compareFunction=qd,n.needsUpdate=!0),n}function kT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=bh(J_):r=j_,t.setTexture2D(e||r,s)}function zT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Q_,s)}function VT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=bh(Z_):r=ex,t.setTextureCube(e||r,s)}function GT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||K_,s)}function HT(n){switch(n){case 5126:return wT;case 35664:return TT;case 35665:return AT;case 35666:return ET;case 35674:return CT;case 35675:return RT;case 35676:return PT;case 5124:case 35670:return IT;case 35667:case 35671:return LT;case 35668:case 35672:return NT;case 35669:case 35673:return DT;case 5125:return FT;case 36294:return OT;case 36295:return UT;case 36296:return BT;case 35678:case 36198:case 36298:case 36306:case 35682:return kT;case 35679:case 36299:case 36307:return zT;case 35680:case 36300:case 36308:case 36293:return VT;case 36289:case 36303:case 36311:case 36292:return GT}}function WT(n,e){n.uniform1fv(this.addr,e)}function $T(n,e){let t=fa(e,this.size,2);n.uniform2fv(this.addr,t)}function XT(n,e){let t=fa(e,this.size,3);n.uniform3fv(this.addr,t)}function qT(n,e){let t=fa(e,this.size,4);n.uniform4fv(this.addr,t)}function YT(n,e){let t=fa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function jT(n,e){let t=fa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function JT(n,e){let t=fa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ZT(n,e){n.uniform1iv(this.addr,e)}function KT(n,e){n.uniform2iv(this.addr,e)}function QT(n,e){n.uniform3iv(this.addr,e)}function eA(n,e){n.uniform4iv(this.addr,e)}function tA(n,e){n.uniform1uiv(this.addr,e)}function nA(n,e){n.uniform2uiv(this.addr,e)}function iA(n,e){n.uniform3uiv(this.addr,e)}function sA(n,e){n.uniform4uiv(this.addr,e)}function rA(n,e,t){let i=this.cache,s=e.length,r=vh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=bh(J_):o=j_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function oA(n,e,t){let i=this.cache,s=e.length,r=vh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Q_,r[o])}function aA(n,e,t){let i=this.cache,s=e.length,r=vh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=bh(Z_):o=ex;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function lA(n,e,t){let i=this.cache,s=e.length,r=vh(t,s);In(i,r)||(n.uniform1iv(this.addr,r),Ln(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||K_,r[o])}function cA(n){switch(n){case 5126:return WT;case 35664:return $T;case 35665:return XT;case 35666:return qT;case 35674:return YT;case 35675:return jT;case 35676:return JT;case 5124:case 35670:return ZT;case 35667:case 35671:return KT;case 35668:case 35672:return QT;case 35669:case 35673:return eA;case 5125:return tA;case 36294:return nA;case 36295:return iA;case 36296:return sA;case 35678:case 36198:case 36298:case 36306:case 35682:return rA;case 35679:case 36299:case 36307:return oA;case 35680:case 36300:case 36308:case 36293:return aA;case 36289:case 36303:case 36311:case 36292:return lA}}var rp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=HT(t.type)}},op=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=cA(t.type)}},ap=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},ip=/(\w+)(\])?(\[|\.)?/g;function N_(n,e){n.seq.push(e),n.map[e.id]=e}function uA(n,e,t){let i=n.name,s=i.length;for(ip.lastIndex=0;;){let r=ip.exec(i),o=ip.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){N_(t,c===void 0?new rp(a,n,e):new op(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new ap(a),N_(t,h)),t=h}}}var ha=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);uA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function D_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var hA=37297,fA=0;function dA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var F_=new it;function pA(n){bt._getMatrix(F_,bt.workingColorSpace,n);let e=`mat3( ${F_.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(n)){case ol:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function O_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+dA(n.getShaderSource(e),a)}else return r}function mA(n,e){let t=pA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gA={[Id]:"Linear",[Ld]:"Reinhard",[Nd]:"Cineon",[Dd]:"ACESFilmic",[Od]:"AgX",[Ud]:"Neutral",[Fd]:"Custom"};function _A(n,e){let t=gA[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var xh=new H;function xA(){bt.getLuminanceCoefficients(xh);let n=xh.x.toFixed(4),e=xh.y.toFixed(4),t=xh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ol).join(`
`)}function vA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function bA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ol(n){return n!==""}function U_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function B_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var SA=/^[ \t]*#include +<([\w\d./]+)>/gm;function lp(n){return n.replace(SA,MA)}function MA(n,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return lp(t)}var wA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function k_(n){return n.replace(wA,TA)}function TA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function z_(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var AA={[El]:"SHADOWMAP_TYPE_PCF",[oa]:"SHADOWMAP_TYPE_VSM"};function EA(n){return AA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var CA={[la]:"ENVMAP_MODE_REFRACTION"};function RA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":CA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var PA={[Cu]:"ENVMAP_BLENDING_MULTIPLY",[n_]:"ENVMAP_BLENDING_MIX",[i_]:"ENVMAP_BLENDING_ADD"};function IA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":PA[n.combine]||"ENVMAP_BLENDING_NONE"}function LA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=EA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=RA(t),h=IA(t),f=yA(t),d=vA(r),y=s.createProgram(),v,g,x=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ol).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ol).join(`
`),g.length>0&&(g+=`
`)):(v=[z_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ol).join(`
`),g=[z_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ss?"#define TONE_MAPPING":"",t.toneMapping!==Ss?dt.tonemapping_pars_fragment:"",t.toneMapping!==Ss?_A("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,mA("linearToOutputTexel",t.outputColorSpace),xA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ol).join(`
`)),o=lp(o),o=U_(o,t),o=B_(o,t),a=lp(a),a=U_(a,t),a=B_(a,t),o=k_(o),a=k_(a),t.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,v=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Yd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Yd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=x+v+o,M=x+g+a,S=D_(s,s.VERTEX_SHADER,_),T=D_(s,s.FRAGMENT_SHADER,M);s.attachShader(y,S),s.attachShader(y,T),t.index0AttributeName!==void 0?s.bindAttribLocation(y,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function b(C){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(y)||"",E=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(T)||"",D=I.trim(),z=E.trim(),X=F.trim(),k=!0,se=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,y,S,T);else{let q=O_(s,S,"vertex"),J=O_(s,T,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+D+`
`+q+`
`+J)}else D!==""?je("WebGLProgram: Program Info Log:",D):(z===""||X==="")&&(se=!1);se&&(C.diagnostics={runnable:k,programLog:D,vertexShader:{log:z,prefix:v},fragmentShader:{log:X,prefix:g}})}s.deleteShader(S),s.deleteShader(T),m=new ha(s,y),w=bA(s,y)}let m;this.getUniforms=function(){return m===void 0&&b(this),m};let w;this.getAttributes=function(){return w===void 0&&b(this),w};let R=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return R===!1&&(R=s.getProgramParameter(y,hA)),R},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=fA++,this.cacheKey=e,this.usedTimes=1,this.program=y,this.vertexShader=S,this.fragmentShader=T,this}var NA=0,cp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new up(e),t.set(e,i)),i}},up=class{constructor(e){this.id=NA++,this.code=e,this.usedTimes=0}};function DA(n){return n===Er||n===Nl||n===Dl}function FA(n,e,t,i,s,r){let o=new ea,a=new cp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(m){return l.add(m),m===0?"uv":`uv${m}`}function y(m,w,R,C,I,E){let F=C.fog,D=I.geometry,z=m.isMeshStandardMaterial||m.isMeshLambertMaterial||m.isMeshPhongMaterial?C.environment:null,X=m.isMeshStandardMaterial||m.isMeshLambertMaterial&&!m.envMap||m.isMeshPhongMaterial&&!m.envMap,k=e.get(m.envMap||z,X),se=f[m.type],q=i.precision;m.precision!==null&&(q=i.getMaxPrecision(m.precision),q!==m.precision&&je("WebGLProgram.getParameters:",m.precision,"not supported, using",q,"instead."));let J=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ne=J!==void 0?J.length:0,pe=0;D.morphAttributes.position!==void 0&&(pe=1),D.morphAttributes.normal!==void 0&&(pe=2),D.morphAttributes.color!==void 0&&(pe=3);let te,j,he,me;if(se){let Ie=ws[se];te=Ie.vertexShader,j=Ie.fragmentShader}else{te=m.vertexShader,j=m.fragmentShader;let Ie=a.getVertexShaderStage(m),ut=a.getFragmentShaderStage(m);a.update(m,Ie,ut),he=Ie.id,me=ut.id}let Q=n.getRenderTarget(),ue=n.state.buffers.depth.getReversed(),Me=I.isInstancedMesh===!0,We=I.isBatchedMesh===!0,Ge=!!m.map,pt=!!m.matcap,ht=!!k,ot=ht&&k.isPMREMTexture===!0,nn=!!m.aoMap,Yt=!!m.lightMap,gn=!!m.bumpMap&&m.wireframe===!1,Gt=!!m.normalMap,Fn=!!m.displacementMap,Tt=!!m.emissiveMap,En=!!m.metalnessMap,on=!!m.roughnessMap,_n=m.anisotropy>0,G=m.clearcoat>0,Le=m.diffuseRoughness>0,Ze=m.dispersion>0,lt=m.retroreflectivity>0,Ee=m.iridescence>0,$t=m.sheen>0,$e=m.transmission>0,Ye=_n&&!!m.anisotropyMap,O=G&&!!m.clearcoatMap,P=G&&!!m.clearcoatNormalMap,Y=G&&!!m.clearcoatRoughnessMap,xe=Le&&!!m.diffuseRoughnessMap,fe=Ee&&!!m.iridescenceMap,Se=Ee&&!!m.iridescenceThicknessMap,we=$t&&!!m.sheenColorMap,re=$t&&!!m.sheenRoughnessMap,le=!!m.specularMap,ve=!!m.specularColorMap,V=!!m.specularIntensityMap,ce=$e&&!!m.transmissionMap,oe=$e&&!!m.thicknessMap,Ce=!!m.gradientMap,be=!!m.alphaMap,Ae=m.alphaTest>0,Xe=!!m.alphaHash,et=!!m.extensions,ge=Ss;m.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(ge=n.toneMapping);let ze=ot?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,tt={shaderID:se,shaderType:m.type,shaderName:m.name,vertexShader:te,fragmentShader:j,defines:m.defines,customVertexShaderID:he,customFragmentShaderID:me,isRawShaderMaterial:m.isRawShaderMaterial===!0,glslVersion:m.glslVersion,precision:q,batching:We,batchingColor:We&&I._colorsTexture!==null,instancing:Me,instancingColor:Me&&I.instanceColor!==null,instancingMorph:Me&&I.morphTexture!==null,outputColorSpace:Q===null?n.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!m.alphaToCoverage,map:Ge,matcap:pt,envMap:ht,envMapMode:ht&&k.mapping,envMapPMREM:ot,envMapMaxLod:ot?ze.length-1:null,envMapSize:ot?ze[0].width:null,aoMap:nn,lightMap:Yt,bumpMap:gn,normalMap:Gt,displacementMap:Fn,emissiveMap:Tt,normalMapObjectSpace:Gt&&m.normalMapType===o_,normalMapTangentSpace:Gt&&m.normalMapType===mh,packedNormalMap:Gt&&m.normalMapType===mh&&DA(m.normalMap.format),metalnessMap:En,roughnessMap:on,anisotropy:_n,anisotropyMap:Ye,clearcoat:G,clearcoatMap:O,clearcoatNormalMap:P,clearcoatRoughnessMap:Y,diffuseRoughness:Le,diffuseRoughnessMap:xe,dispersion:Ze,retroreflection:lt,iridescence:Ee,iridescenceMap:fe,iridescenceThicknessMap:Se,sheen:$t,sheenColorMap:we,sheenRoughnessMap:re,specularMap:le,specularColorMap:ve,specularIntensityMap:V,transmission:$e,transmissionMap:ce,thicknessMap:oe,gradientMap:Ce,opaque:m.transparent===!1&&m.blending===aa&&m.alphaToCoverage===!1,alphaMap:be,alphaTest:Ae,alphaHash:Xe,combine:m.combine,mapUv:Ge&&d(m.map.channel),aoMapUv:nn&&d(m.aoMap.channel),lightMapUv:Yt&&d(m.lightMap.channel),bumpMapUv:gn&&d(m.bumpMap.channel),normalMapUv:Gt&&d(m.normalMap.channel),displacementMapUv:Fn&&d(m.displacementMap.channel),emissiveMapUv:Tt&&d(m.emissiveMap.channel),metalnessMapUv:En&&d(m.metalnessMap.channel),roughnessMapUv:on&&d(m.roughnessMap.channel),anisotropyMapUv:Ye&&d(m.anisotropyMap.channel),clearcoatMapUv:O&&d(m.clearcoatMap.channel),clearcoatNormalMapUv:P&&d(m.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&d(m.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:xe&&d(m.diffuseRoughnessMap.channel),iridescenceMapUv:fe&&d(m.iridescenceMap.channel),iridescenceThicknessMapUv:Se&&d(m.iridescenceThicknessMap.channel),sheenColorMapUv:we&&d(m.sheenColorMap.channel),sheenRoughnessMapUv:re&&d(m.sheenRoughnessMap.channel),specularMapUv:le&&d(m.specularMap.channel),specularColorMapUv:ve&&d(m.specularColorMap.channel),specularIntensityMapUv:V&&d(m.specularIntensityMap.channel),transmissionMapUv:ce&&d(m.transmissionMap.channel),thicknessMapUv:oe&&d(m.thicknessMap.channel),alphaMapUv:be&&d(m.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Gt||_n),vertexNormals:!!D.attributes.normal,vertexColors:m.vertexColors,vertexAlphas:m.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Ge||be),fog:!!F,useFog:m.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:m.wireframe===!1&&(m.flatShading===!0||D.attributes.normal===void 0&&Gt===!1&&(m.isMeshLambertMaterial||m.isMeshPhongMaterial||m.isMeshStandardMaterial||m.isMeshPhysicalMaterial)),sizeAttenuation:m.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ue,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:pe,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:E.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:m.dithering,shadowMapEnabled:n.shadowMap.enabled&&R.length>0,shadowMapType:n.shadowMap.type,toneMapping:ge,decodeVideoTexture:Ge&&m.map.isVideoTexture===!0&&bt.getTransfer(m.map.colorSpace)===Dt,decodeVideoTextureEmissive:Tt&&m.emissiveMap.isVideoTexture===!0&&bt.getTransfer(m.emissiveMap.colorSpace)===Dt,premultipliedAlpha:m.premultipliedAlpha,doubleSided:m.side===mi,flipSided:m.side===fi,useDepthPacking:m.depthPacking>=0,depthPacking:m.depthPacking||0,index0AttributeName:m.index0AttributeName,extensionClipCullDistance:et&&m.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&m.extensions.multiDraw===!0||We)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:m.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function v(m){let w=[];if(m.shaderID?w.push(m.shaderID):(w.push(m.customVertexShaderID),w.push(m.customFragmentShaderID)),m.defines!==void 0)for(let R in m.defines)w.push(R),w.push(m.defines[R]);return m.isRawShaderMaterial===!1&&(g(w,m),x(w,m),w.push(n.outputColorSpace)),w.push(m.customProgramCacheKey),w.join()}function g(m,w){m.push(w.precision),m.push(w.outputColorSpace),m.push(w.envMapMode),m.push(w.envMapPMREM),m.push(w.envMapMaxLod),m.push(w.envMapSize),m.push(w.mapUv),m.push(w.alphaMapUv),m.push(w.lightMapUv),m.push(w.aoMapUv),m.push(w.bumpMapUv),m.push(w.normalMapUv),m.push(w.displacementMapUv),m.push(w.emissiveMapUv),m.push(w.metalnessMapUv),m.push(w.roughnessMapUv),m.push(w.anisotropyMapUv),m.push(w.clearcoatMapUv),m.push(w.clearcoatNormalMapUv),m.push(w.clearcoatRoughnessMapUv),m.push(w.diffuseRoughnessMapUv),m.push(w.iridescenceMapUv),m.push(w.iridescenceThicknessMapUv),m.push(w.sheenColorMapUv),m.push(w.sheenRoughnessMapUv),m.push(w.specularMapUv),m.push(w.specularColorMapUv),m.push(w.specularIntensityMapUv),m.push(w.transmissionMapUv),m.push(w.thicknessMapUv),m.push(w.combine),m.push(w.fogExp2),m.push(w.sizeAttenuation),m.push(w.morphTargetsCount),m.push(w.numSunLights),m.push(w.numDirLights),m.push(w.numPointLights),m.push(w.numSpotLights),m.push(w.numSpotLightMaps),m.push(w.numHemiLights),m.push(w.numRectAreaLights),m.push(w.numSunLightShadows),m.push(w.numDirLightShadows),m.push(w.numPointLightShadows),m.push(w.numSpotLightShadows),m.push(w.numSpotLightShadowsWithMaps),m.push(w.numLightProbes),m.push(w.numLightProbeGrids),m.push(w.shadowMapType),m.push(w.toneMapping),m.push(w.numClippingPlanes),m.push(w.numClipIntersection),m.push(w.depthPacking)}function x(m,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),m.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),m.push(o.mask)}function _(m){let w=f[m.type],R;if(w){let C=ws[w];R=b_.clone(C.uniforms)}else R=m.uniforms;return R}function M(m,w){let R=u.get(w);return R!==void 0?++R.usedTimes:(R=new LA(n,w,m,s),c.push(R),u.set(w,R)),R}function S(m){if(--m.usedTimes===0){let w=c.indexOf(m);c[w]=c[c.length-1],c.pop(),u.delete(m.cacheKey),m.destroy()}}function T(m){a.remove(m)}function b(){a.dispose()}return{getParameters:y,getProgramCacheKey:v,getUniforms:_,acquireProgram:M,releaseProgram:S,releaseShaderCache:T,programs:c,dispose:b}}function OA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function UA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function V_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function G_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,y,v,g,x){let _=n[e];return _===void 0?(_={id:f.id,object:f,geometry:d,material:y,materialVariant:o(f),groupOrder:v,renderOrder:f.renderOrder,z:g,group:x},n[e]=_):(_.id=f.id,_.object=f,_.geometry=d,_.material=y,_.materialVariant=o(f),_.groupOrder=v,_.renderOrder=f.renderOrder,_.z=g,_.group=x),e++,_}function l(f,d,y,v,g,x,_){_.reversedDepth===!0&&(g=-g);let M=a(f,d,y,v,g,x);y.transmission>0?i.push(M):y.transparent===!0?s.push(M):t.push(M)}function c(f,d,y,v,g,x){let _=a(f,d,y,v,g,x);y.transmission>0?i.unshift(_):y.transparent===!0?s.unshift(_):t.unshift(_)}function u(f,d){t.length>1&&t.sort(f||UA),i.length>1&&i.sort(d||V_),s.length>1&&s.sort(d||V_)}function h(){for(let f=e,d=n.length;f<d;f++){let y=n[f];if(y.id===null)break;y.id=null,y.object=null,y.geometry=null,y.material=null,y.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function BA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new G_,n.set(i,[o])):s>=r.length?(o=new G_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function kA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new H,color:new rt};break;case"SpotLight":t={position:new H,direction:new H,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new H,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new H,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new H,halfWidth:new H,halfHeight:new H};break}return n[e.id]=t,t}}}function zA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var VA=0;function GA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function HA(n){let e=new kA,t=zA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new Je,o=new Je;function a(c){let u=0,h=0,f=0;for(let E=0;E<9;E++)i.probe[E].set(0,0,0);let d=0,y=0,v=0,g=0,x=0,_=0,M=0,S=0,T=0,b=0,m=0,w=0,R=0,C=0;c.sort(GA);for(let E=0,F=c.length;E<F;E++){let D=c[E],z=D.color,X=D.intensity,k=D.distance,se=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Er?se=D.shadow.map.texture:se=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=z.r*X,h+=z.g*X,f+=z.b*X;else if(D.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(D.sh.coefficients[q],X);C++}else if(D.isSunLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let J=D.shadow,ne=t.get(D);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[y]=ne,i.sunShadowMap[y]=se;let pe=J.getViewportCount();for(let te=0;te<pe;te++)i.sunShadowMatrix[v+te]=J.getMatrix(te),i.sunShadowCascade[v+te]=J._cascadeData[te];v+=pe,y++}i.sun[d]=q,d++}else if(D.isDirectionalLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let J=D.shadow,ne=t.get(D);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,i.directionalShadow[g]=ne,i.directionalShadowMap[g]=se,i.directionalShadowMatrix[g]=D.shadow.matrix,T++}i.directional[g]=q,g++}else if(D.isSpotLight){let q=e.get(D);q.position.setFromMatrixPosition(D.matrixWorld),q.color.copy(z).multiplyScalar(X),q.distance=k,q.coneCos=Math.cos(D.angle),q.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),q.decay=D.decay,i.spot[_]=q;let J=D.shadow;if(D.map&&(i.spotLightMap[w]=D.map,w++,J.updateMatrices(D),D.castShadow&&R++),i.spotLightMatrix[_]=J.matrix,D.castShadow){let ne=t.get(D);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,i.spotShadow[_]=ne,i.spotShadowMap[_]=se,m++}_++}else if(D.isRectAreaLight){let q=e.get(D);q.color.copy(z).multiplyScalar(X),q.halfWidth.set(D.width*.5,0,0),q.halfHeight.set(0,D.height*.5,0),i.rectArea[M]=q,M++}else if(D.isPointLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),q.distance=D.distance,q.decay=D.decay,D.castShadow){let J=D.shadow,ne=t.get(D);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,ne.shadowCameraNear=J.camera.near,ne.shadowCameraFar=J.camera.far,i.pointShadow[x]=ne,i.pointShadowMap[x]=se,i.pointShadowMatrix[x]=D.shadow.matrix,b++}i.point[x]=q,x++}else if(D.isHemisphereLight){let q=e.get(D);q.skyColor.copy(D.color).multiplyScalar(X),q.groundColor.copy(D.groundColor).multiplyScalar(X),i.hemi[S]=q,S++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Fe.LTC_FLOAT_1,i.rectAreaLTC2=Fe.LTC_FLOAT_2):(i.rectAreaLTC1=Fe.LTC_HALF_1,i.rectAreaLTC2=Fe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let I=i.hash;(I.sunLength!==d||I.directionalLength!==g||I.pointLength!==x||I.spotLength!==_||I.rectAreaLength!==M||I.hemiLength!==S||I.numSunShadows!==y||I.numDirectionalShadows!==T||I.numPointShadows!==b||I.numSpotShadows!==m||I.numSpotMaps!==w||I.numLightProbes!==C)&&(i.sun.length=d,i.directional.length=g,i.spot.length=_,i.rectArea.length=M,i.point.length=x,i.hemi.length=S,i.sunShadow.length=y,i.sunShadowMap.length=y,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=m,i.spotShadowMap.length=m,i.spotLightMatrix.length=m+w-R,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=C,I.sunLength=d,I.directionalLength=g,I.pointLength=x,I.spotLength=_,I.rectAreaLength=M,I.hemiLength=S,I.numSunShadows=y,I.numDirectionalShadows=T,I.numPointShadows=b,I.numSpotShadows=m,I.numSpotMaps=w,I.numLightProbes=C,i.version=VA++)}function l(c,u){let h=0,f=0,d=0,y=0,v=0,g=0,x=u.matrixWorldInverse;for(let _=0,M=c.length;_<M;_++){let S=c[_];if(S.isSunLight){let T=i.sun[h];T.direction.setFromMatrixPosition(S.matrixWorld),T.direction.transformDirection(x),h++}else if(S.isDirectionalLight){let T=i.directional[f];T.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),f++}else if(S.isSpotLight){let T=i.spot[y];T.position.setFromMatrixPosition(S.matrixWorld),T.position.applyMatrix4(x),T.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),y++}else if(S.isRectAreaLight){let T=i.rectArea[v];T.position.setFromMatrixPosition(S.matrixWorld),T.position.applyMatrix4(x),o.identity(),r.copy(S.matrixWorld),r.premultiply(x),o.extractRotation(r),T.halfWidth.set(S.width*.5,0,0),T.halfHeight.set(0,S.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),v++}else if(S.isPointLight){let T=i.point[d];T.position.setFromMatrixPosition(S.matrixWorld),T.position.applyMatrix4(x),d++}else if(S.isHemisphereLight){let T=i.hemi[g];T.direction.setFromMatrixPosition(S.matrixWorld),T.direction.transformDirection(x),g++}}}return{setup:a,setupView:l,state:i}}function H_(n){let e=new HA(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function WA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new H_(n),e.set(s,[a])):r>=o.length?(a=new H_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var $A=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,XA=`uniform sampler2D shadow_pass;
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
}`,qA=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],YA=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],W_=new Je,Fl=new H,sp=new H;function jA(n,e,t){let i=new vr,s=new Qe,r=new Qe,o=new Wt,a=new mu,l=new gu,c={},u=t.maxTextureSize,h={[Ar]:fi,[fi]:Ar,[mi]:mi},f=new Gi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qe},radius:{value:4}},vertexShader:$A,fragmentShader:XA}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let y=new jn;y.setAttribute("position",new Ft(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Tn(y,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=El;let x=this.type;this.render=function(b,m,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||b.length===0)return;this.type===U0&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=El);let R=n.getRenderTarget(),C=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),E=n.state;E.setBlending(Zr),E.buffers.depth.getReversed()===!0?E.buffers.color.setClear(0,0,0,0):E.buffers.color.setClear(1,1,1,1),E.buffers.depth.setTest(!0),E.setScissorTest(!1);let F=x!==this.type;F&&m.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(z=>z.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,z=b.length;D<z;D++){let X=b[D],k=X.shadow;if(k===void 0){je("WebGLShadowMap:",X,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let se=k.getFrameExtents();s.multiply(se),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/se.x),s.x=r.x*se.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/se.y),s.y=r.y*se.y,k.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=q,k.map===null||F===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===oa){if(X.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new Ri(s.x,s.y,{format:Er,type:ns,minFilter:hi,magFilter:hi,generateMipmaps:!1}),k.map.texture.name=X.name+".shadowMap",k.map.depthTexture=new js(s.x,s.y,Hi),k.map.depthTexture.name=X.name+".shadowMapDepth",k.map.depthTexture.format=Hs,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Hn,k.map.depthTexture.magFilter=Hn}else X.isPointLight?(k.map=new Ul(s.x),k.map.depthTexture=new gl(s.x,ts)):(k.map=new Ri(s.x,s.y),k.map.depthTexture=new js(s.x,s.y,ts)),k.map.depthTexture.name=X.name+".shadowMap",k.map.depthTexture.format=Hs,this.type===El?(k.map.depthTexture.compareFunction=q?Xd:$d,k.map.depthTexture.minFilter=hi,k.map.depthTexture.magFilter=hi):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Hn,k.map.depthTexture.magFilter=Hn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let J=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();X.isPointLight!==!0&&k.updateMatrices(X,w);let ne=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:w.layers;for(let pe=0;pe<J;pe++){let te=k.getCamera(pe);if(X.isPointLight){let j=k.camera,he=k.matrix,me=X.distance||j.far;me!==j.far&&(j.far=me,j.updateProjectionMatrix()),Fl.setFromMatrixPosition(X.matrixWorld),j.position.copy(Fl),sp.copy(j.position),sp.add(qA[pe]),j.up.copy(YA[pe]),j.lookAt(sp),j.updateMatrixWorld(),he.makeTranslation(-Fl.x,-Fl.y,-Fl.z),W_.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),k._frustum.setFromProjectionMatrix(W_,j.coordinateSystem,j.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(k.map),n.clear());let j=k.getViewport(pe);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),E.viewport(o)}i=k.getFrustum(pe),S(m,w,te,X,ne,this.type)}k.isPointLightShadow!==!0&&this.type===oa&&_(k,w),k.needsUpdate=!1}x=this.type,g.needsUpdate=!1,n.setRenderTarget(R,C,I)};function _(b,m){let w=e.update(v);f.defines.VSM_SAMPLES!==b.blurSamples&&(f.defines.VSM_SAMPLES=b.blurSamples,d.defines.VSM_SAMPLES=b.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),b.mapPass===null?b.mapPass=new Ri(s.x,s.y,{format:Er,type:ns}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),f.uniforms.shadow_pass.value=b.map.depthTexture,f.uniforms.resolution.value.set(b.map.width,b.map.height),f.uniforms.radius.value=b.radius,n.setRenderTarget(b.mapPass),n.clear(),n.renderBufferDirect(m,null,w,f,v,null),d.uniforms.shadow_pass.value=b.mapPass.texture,d.uniforms.resolution.value.set(b.map.width,b.map.height),d.uniforms.radius.value=b.radius,n.setRenderTarget(b.map),n.clear(),n.renderBufferDirect(m,null,w,d,v,null)}function M(b,m,w,R){let C=null,I=w.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(I!==void 0)C=I;else if(C=w.isPointLight===!0?l:a,n.localClippingEnabled&&m.clipShadows===!0&&Array.isArray(m.clippingPlanes)&&m.clippingPlanes.length!==0||m.displacementMap&&m.displacementScale!==0||m.alphaMap&&m.alphaTest>0||m.map&&m.alphaTest>0||m.alphaToCoverage===!0){let E=C.uuid,F=m.uuid,D=c[E];D===void 0&&(D={},c[E]=D);let z=D[F];z===void 0&&(z=C.clone(),D[F]=z,m.addEventListener("dispose",T)),C=z}if(C.visible=m.visible,C.wireframe=m.wireframe,R===oa?C.side=m.shadowSide!==null?m.shadowSide:m.side:C.side=m.shadowSide!==null?m.shadowSide:h[m.side],C.alphaMap=m.alphaMap,C.alphaTest=m.alphaToCoverage===!0?.5:m.alphaTest,C.map=m.map,C.clipShadows=m.clipShadows,C.clippingPlanes=m.clippingPlanes,C.clipIntersection=m.clipIntersection,C.displacementMap=m.displacementMap,C.displacementScale=m.displacementScale,C.displacementBias=m.displacementBias,C.wireframeLinewidth=m.wireframeLinewidth,C.linewidth=m.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let E=n.properties.get(C);E.light=w}return C}function S(b,m,w,R,C,I){if(b.visible===!1)return;if(b.layers.test(C)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&I===oa)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,b.matrixWorld);let D=e.update(b),z=b.material;if(Array.isArray(z)){let X=D.groups;for(let k=0,se=X.length;k<se;k++){let q=X[k],J=z[q.materialIndex];if(J&&J.visible){let ne=M(b,J,R,I);b.onBeforeShadow(n,b,m,w,D,ne,q),n.renderBufferDirect(w,null,D,ne,b,q),b.onAfterShadow(n,b,m,w,D,ne,q)}}}else if(z.visible){let X=M(b,z,R,I);b.onBeforeShadow(n,b,m,w,D,X,null),n.renderBufferDirect(w,null,D,X,b,null),b.onAfterShadow(n,b,m,w,D,X,null)}}let F=b.children;for(let D=0,z=F.length;D<z;D++)S(F[D],m,w,R,C,I)}function T(b){b.target.removeEventListener("dispose",T);for(let w in c){let R=c[w],C=b.target.uuid;C in R&&(R[C].dispose(),delete R[C])}}}function JA(n,e){function t(){let V=!1,ce=new Wt,oe=null,Ce=new Wt(0,0,0,0);return{setMask:function(be){oe!==be&&!V&&(n.colorMask(be,be,be,be),oe=be)},setLocked:function(be){V=be},setClear:function(be,Ae,Xe,et,ge){ge===!0&&(be*=et,Ae*=et,Xe*=et),ce.set(be,Ae,Xe,et),Ce.equals(ce)===!1&&(n.clearColor(be,Ae,Xe,et),Ce.copy(ce))},reset:function(){V=!1,oe=null,Ce.set(-1,0,0,0)}}}function i(){let V=!1,ce=!1,oe=null,Ce=null,be=null;return{setReversed:function(Ae){if(ce!==Ae){let Xe=e.get("EXT_clip_control");Ae?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),ce=Ae;let et=be;be=null,this.setClear(et)}},getReversed:function(){return ce},setTest:function(Ae){Ae?ue(n.DEPTH_TEST):Me(n.DEPTH_TEST)},setMask:function(Ae){oe!==Ae&&!V&&(n.depthMask(Ae),oe=Ae)},setFunc:function(Ae){if(ce&&(Ae=__[Ae]),Ce!==Ae){switch(Ae){case Zc:n.depthFunc(n.NEVER);break;case Kc:n.depthFunc(n.ALWAYS);break;case Qc:n.depthFunc(n.LESS);break;case jo:n.depthFunc(n.LEQUAL);break;case eu:n.depthFunc(n.EQUAL);break;case tu:n.depthFunc(n.GEQUAL);break;case nu:n.depthFunc(n.GREATER);break;case iu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ce=Ae}},setLocked:function(Ae){V=Ae},setClear:function(Ae){be!==Ae&&(be=Ae,ce&&(Ae=1-Ae),n.clearDepth(Ae))},reset:function(){V=!1,oe=null,Ce=null,be=null,ce=!1}}}function s(){let V=!1,ce=null,oe=null,Ce=null,be=null,Ae=null,Xe=null,et=null,ge=null;return{setTest:function(ze){V||(ze?ue(n.STENCIL_TEST):Me(n.STENCIL_TEST))},setMask:function(ze){ce!==ze&&!V&&(n.stencilMask(ze),ce=ze)},setFunc:function(ze,tt,Ie){(oe!==ze||Ce!==tt||be!==Ie)&&(n.stencilFunc(ze,tt,Ie),oe=ze,Ce=tt,be=Ie)},setOp:function(ze,tt,Ie){(Ae!==ze||Xe!==tt||et!==Ie)&&(n.stencilOp(ze,tt,Ie),Ae=ze,Xe=tt,et=Ie)},setLocked:function(ze){V=ze},setClear:function(ze){ge!==ze&&(n.clearStencil(ze),ge=ze)},reset:function(){V=!1,ce=null,oe=null,Ce=null,be=null,Ae=null,Xe=null,et=null,ge=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,y=[],v=null,g=!1,x=null,_=null,M=null,S=null,T=null,b=null,m=null,w=new rt(0,0,0),R=0,C=!1,I=null,E=null,F=null,D=null,z=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,se=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec(q)[1]),k=se>=1):q.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),k=se>=2);let J=null,ne={},pe=n.getParameter(n.SCISSOR_BOX),te=n.getParameter(n.VIEWPORT),j=new Wt().fromArray(pe),he=new Wt().fromArray(te);function me(V,ce,oe,Ce){let be=new Uint8Array(4),Ae=n.createTexture();n.bindTexture(V,Ae),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<oe;Xe++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(ce,0,n.RGBA,1,1,Ce,0,n.RGBA,n.UNSIGNED_BYTE,be):n.texImage2D(ce+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,be);return Ae}let Q={};Q[n.TEXTURE_2D]=me(n.TEXTURE_2D,n.TEXTURE_2D,1),Q[n.TEXTURE_CUBE_MAP]=me(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[n.TEXTURE_2D_ARRAY]=me(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Q[n.TEXTURE_3D]=me(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ue(n.DEPTH_TEST),o.setFunc(jo),gn(!1),Gt(Td),ue(n.CULL_FACE),nn(Zr);function ue(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Me(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function We(V,ce){return f[V]!==ce?(n.bindFramebuffer(V,ce),f[V]=ce,V===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=ce),V===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=ce),!0):!1}function Ge(V,ce){let oe=y,Ce=!1;if(V){oe=d.get(ce),oe===void 0&&(oe=[],d.set(ce,oe));let be=V.textures;if(oe.length!==be.length||oe[0]!==n.COLOR_ATTACHMENT0){for(let Ae=0,Xe=be.length;Ae<Xe;Ae++)oe[Ae]=n.COLOR_ATTACHMENT0+Ae;oe.length=be.length,Ce=!0}}else oe[0]!==n.BACK&&(oe[0]=n.BACK,Ce=!0);Ce&&n.drawBuffers(oe)}function pt(V){return v!==V?(n.useProgram(V),v=V,!0):!1}let ht={[Kr]:n.FUNC_ADD,[k0]:n.FUNC_SUBTRACT,[z0]:n.FUNC_REVERSE_SUBTRACT};ht[V0]=n.MIN,ht[G0]=n.MAX;let ot={[H0]:n.ZERO,[W0]:n.ONE,[$0]:n.SRC_COLOR,[Rd]:n.SRC_ALPHA,[Z0]:n.SRC_ALPHA_SATURATE,[j0]:n.DST_COLOR,[q0]:n.DST_ALPHA,[X0]:n.ONE_MINUS_SRC_COLOR,[Pd]:n.ONE_MINUS_SRC_ALPHA,[J0]:n.ONE_MINUS_DST_COLOR,[Y0]:n.ONE_MINUS_DST_ALPHA,[K0]:n.CONSTANT_COLOR,[Q0]:n.ONE_MINUS_CONSTANT_COLOR,[e_]:n.CONSTANT_ALPHA,[t_]:n.ONE_MINUS_CONSTANT_ALPHA};function nn(V,ce,oe,Ce,be,Ae,Xe,et,ge,ze){if(V===Zr){g===!0&&(Me(n.BLEND),g=!1);return}if(g===!1&&(ue(n.BLEND),g=!0),V!==B0){if(V!==x||ze!==C){if((_!==Kr||T!==Kr)&&(n.blendEquation(n.FUNC_ADD),_=Kr,T=Kr),ze)switch(V){case aa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFunc(n.ONE,n.ONE);break;case Ed:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Cd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:nt("WebGLState: Invalid blending: ",V);break}else switch(V){case aa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ed:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cd:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",V);break}M=null,S=null,b=null,m=null,w.set(0,0,0),R=0,x=V,C=ze}return}be=be||ce,Ae=Ae||oe,Xe=Xe||Ce,(ce!==_||be!==T)&&(n.blendEquationSeparate(ht[ce],ht[be]),_=ce,T=be),(oe!==M||Ce!==S||Ae!==b||Xe!==m)&&(n.blendFuncSeparate(ot[oe],ot[Ce],ot[Ae],ot[Xe]),M=oe,S=Ce,b=Ae,m=Xe),(et.equals(w)===!1||ge!==R)&&(n.blendColor(et.r,et.g,et.b,ge),w.copy(et),R=ge),x=V,C=!1}function Yt(V,ce){V.side===mi?Me(n.CULL_FACE):ue(n.CULL_FACE);let oe=V.side===fi;ce&&(oe=!oe),gn(oe),V.blending===aa&&V.transparent===!1?nn(Zr):nn(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Ce=V.stencilWrite;a.setTest(Ce),Ce&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Tt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?ue(n.SAMPLE_ALPHA_TO_COVERAGE):Me(n.SAMPLE_ALPHA_TO_COVERAGE)}function gn(V){I!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),I=V)}function Gt(V){V!==F0?(ue(n.CULL_FACE),V!==E&&(V===Td?n.cullFace(n.BACK):V===O0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Me(n.CULL_FACE),E=V}function Fn(V){V!==F&&(k&&n.lineWidth(V),F=V)}function Tt(V,ce,oe){V?(ue(n.POLYGON_OFFSET_FILL),(D!==ce||z!==oe)&&(D=ce,z=oe,o.getReversed()&&(ce=-ce,oe=-oe),n.polygonOffset(ce,oe))):Me(n.POLYGON_OFFSET_FILL)}function En(V){V?ue(n.SCISSOR_TEST):Me(n.SCISSOR_TEST)}function on(V){V===void 0&&(V=n.TEXTURE0+X-1),J!==V&&(n.activeTexture(V),J=V)}function _n(V,ce,oe){oe===void 0&&(J===null?oe=n.TEXTURE0+X-1:oe=J);let Ce=ne[oe];Ce===void 0&&(Ce={type:void 0,texture:void 0},ne[oe]=Ce),(Ce.type!==V||Ce.texture!==ce)&&(J!==oe&&(n.activeTexture(oe),J=oe),n.bindTexture(V,ce||Q[V]),Ce.type=V,Ce.texture=ce)}function G(){let V=ne[J];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(V){nt("WebGLState:",V)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(V){nt("WebGLState:",V)}}function lt(){try{n.texSubImage2D(...arguments)}catch(V){nt("WebGLState:",V)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(V){nt("WebGLState:",V)}}function $t(){try{n.compressedTexSubImage2D(...arguments)}catch(V){nt("WebGLState:",V)}}function $e(){try{n.compressedTexSubImage3D(...arguments)}catch(V){nt("WebGLState:",V)}}function Ye(){try{n.texStorage2D(...arguments)}catch(V){nt("WebGLState:",V)}}function O(){try{n.texStorage3D(...arguments)}catch(V){nt("WebGLState:",V)}}function P(){try{n.texImage2D(...arguments)}catch(V){nt("WebGLState:",V)}}function Y(){try{n.texImage3D(...arguments)}catch(V){nt("WebGLState:",V)}}function xe(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function fe(V,ce){h[V]!==ce&&(n.pixelStorei(V,ce),h[V]=ce)}function Se(V){j.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),j.copy(V))}function we(V){he.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),he.copy(V))}function re(V,ce){let oe=c.get(ce);oe===void 0&&(oe=new WeakMap,c.set(ce,oe));let Ce=oe.get(V);Ce===void 0&&(Ce=n.getUniformBlockIndex(ce,V.name),n.uniformBlockBinding(ce,Ce,Ce),oe.set(V,Ce))}function le(V,ce,oe){let be=c.get(ce).get(V);l[be]!==oe&&(n.bindBufferBase(n.UNIFORM_BUFFER,be,oe),l[be]=oe)}function ve(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,ne={},f={},l={},d=new WeakMap,y=[],v=null,g=!1,x=null,_=null,M=null,S=null,T=null,b=null,m=null,w=new rt(0,0,0),R=0,C=!1,I=null,E=null,F=null,D=null,z=null,j.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ue,disable:Me,bindFramebuffer:We,drawBuffers:Ge,useProgram:pt,setBlending:nn,setMaterial:Yt,setFlipSided:gn,setCullFace:Gt,setLineWidth:Fn,setPolygonOffset:Tt,setScissorTest:En,activeTexture:on,bindTexture:_n,unbindTexture:G,compressedTexImage2D:Le,compressedTexImage3D:Ze,texImage2D:P,texImage3D:Y,pixelStorei:fe,getParameter:xe,updateUBOMapping:re,uniformBlockBinding:le,texStorage2D:Ye,texStorage3D:O,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:$t,compressedTexSubImage3D:$e,scissor:Se,viewport:we,reset:ve}}function ZA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Qe,u=new WeakMap,h=new Set,f,d=new WeakMap,y=new Set,v=new FinalizationRegistry(O=>y.delete(O)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(O,P){return g?new OffscreenCanvas(O,P):al("canvas")}function _(O,P,Y){let xe=1,fe=Ye(O);if((fe.width>Y||fe.height>Y)&&(xe=Y/Math.max(fe.width,fe.height)),xe<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let Se=Math.floor(xe*fe.width),we=Math.floor(xe*fe.height);f===void 0&&(f=x(Se,we));let re=P?x(Se,we):f;return re.width=Se,re.height=we,re.getContext("2d").drawImage(O,0,0,Se,we),je("WebGLRenderer: Texture has been resized from ("+fe.width+"x"+fe.height+") to ("+Se+"x"+we+")."),re}else return"data"in O&&je("WebGLRenderer: Image in DataTexture is too big ("+fe.width+"x"+fe.height+")."),O;return O}function M(O){return O.generateMipmaps}function S(O){n.generateMipmap(O)}function T(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(O,P,Y,xe,fe,Se=!1){if(O!==null){if(n[O]!==void 0)return n[O];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let we;xe&&(we=e.get("EXT_texture_norm16"),we||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let re=P;if(P===n.RED&&(Y===n.FLOAT&&(re=n.R32F),Y===n.HALF_FLOAT&&(re=n.R16F),Y===n.UNSIGNED_BYTE&&(re=n.R8),Y===n.UNSIGNED_SHORT&&we&&(re=we.R16_EXT),Y===n.SHORT&&we&&(re=we.R16_SNORM_EXT)),P===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(re=n.R8UI),Y===n.UNSIGNED_SHORT&&(re=n.R16UI),Y===n.UNSIGNED_INT&&(re=n.R32UI),Y===n.BYTE&&(re=n.R8I),Y===n.SHORT&&(re=n.R16I),Y===n.INT&&(re=n.R32I)),P===n.RG&&(Y===n.FLOAT&&(re=n.RG32F),Y===n.HALF_FLOAT&&(re=n.RG16F),Y===n.UNSIGNED_BYTE&&(re=n.RG8),Y===n.UNSIGNED_SHORT&&we&&(re=we.RG16_EXT),Y===n.SHORT&&we&&(re=we.RG16_SNORM_EXT)),P===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(re=n.RG8UI),Y===n.UNSIGNED_SHORT&&(re=n.RG16UI),Y===n.UNSIGNED_INT&&(re=n.RG32UI),Y===n.BYTE&&(re=n.RG8I),Y===n.SHORT&&(re=n.RG16I),Y===n.INT&&(re=n.RG32I)),P===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(re=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(re=n.RGB16UI),Y===n.UNSIGNED_INT&&(re=n.RGB32UI),Y===n.BYTE&&(re=n.RGB8I),Y===n.SHORT&&(re=n.RGB16I),Y===n.INT&&(re=n.RGB32I)),P===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(re=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(re=n.RGBA16UI),Y===n.UNSIGNED_INT&&(re=n.RGBA32UI),Y===n.BYTE&&(re=n.RGBA8I),Y===n.SHORT&&(re=n.RGBA16I),Y===n.INT&&(re=n.RGBA32I)),P===n.RGB&&(Y===n.UNSIGNED_SHORT&&we&&(re=we.RGB16_EXT),Y===n.SHORT&&we&&(re=we.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(re=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(re=n.R11F_G11F_B10F)),P===n.RGBA){let le=Se?ol:bt.getTransfer(fe);Y===n.FLOAT&&(re=n.RGBA32F),Y===n.HALF_FLOAT&&(re=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(re=le===Dt?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&we&&(re=we.RGBA16_EXT),Y===n.SHORT&&we&&(re=we.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(re=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(re=n.RGB5_A1)}return(re===n.R16F||re===n.R32F||re===n.RG16F||re===n.RG32F||re===n.RGBA16F||re===n.RGBA32F)&&e.get("EXT_color_buffer_float"),re}function m(O,P){let Y;return O?P===null||P===ts||P===eo?Y=n.DEPTH24_STENCIL8:P===Hi?Y=n.DEPTH32F_STENCIL8:P===ca&&(Y=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):P===null||P===ts||P===eo?Y=n.DEPTH_COMPONENT24:P===Hi?Y=n.DEPTH_COMPONENT32F:P===ca&&(Y=n.DEPTH_COMPONENT16),Y}function w(O,P){return M(O)===!0||O.isFramebufferTexture&&O.minFilter!==Hn&&O.minFilter!==hi?Math.log2(Math.max(P.width,P.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?P.mipmaps.length:1}function R(O){let P=new WeakRef(O);i.get(O).__ref=P,y.add(P),v.register(O,P,P)}function C(O){let P=i.get(O).__ref;P!==void 0&&(y.delete(P),v.unregister(P))}function I(O){F(O.target)}function E(O){D(O.target)}function F(O){O.removeEventListener("dispose",I),C(O),X(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function D(O){O.removeEventListener("dispose",E),C(O),se(O)}function z(){for(let O of y){let P=O.deref();P!==void 0&&(P.isRenderTarget===!0?D(P):F(P))}y.clear(),h.clear()}function X(O){let P=i.get(O);if(P.__webglInit===void 0)return;let Y=O.source,xe=d.get(Y);if(xe){let fe=xe[P.__cacheKey];fe.usedTimes--,fe.usedTimes===0&&k(O),Object.keys(xe).length===0&&d.delete(Y)}i.remove(O)}function k(O){let P=i.get(O);n.deleteTexture(P.__webglTexture);let Y=O.source,xe=d.get(Y);delete xe[P.__cacheKey],o.memory.textures--}function se(O){let P=i.get(O);P.__depthDisposeCallback&&P.__depthDisposeCallback();let Y=O.depthTexture;if(Y&&Y.renderTarget===O&&F(Y),O.isWebGLCubeRenderTarget)for(let fe=0;fe<6;fe++){if(Array.isArray(P.__webglFramebuffer[fe]))for(let Se=0;Se<P.__webglFramebuffer[fe].length;Se++)n.deleteFramebuffer(P.__webglFramebuffer[fe][Se]);else n.deleteFramebuffer(P.__webglFramebuffer[fe]);P.__webglDepthbuffer&&n.deleteRenderbuffer(P.__webglDepthbuffer[fe])}else{if(Array.isArray(P.__webglFramebuffer))for(let fe=0;fe<P.__webglFramebuffer.length;fe++)n.deleteFramebuffer(P.__webglFramebuffer[fe]);else n.deleteFramebuffer(P.__webglFramebuffer);if(P.__webglDepthbuffer&&n.deleteRenderbuffer(P.__webglDepthbuffer),P.__webglMultisampledFramebuffer&&n.deleteFramebuffer(P.__webglMultisampledFramebuffer),P.__webglColorRenderbuffer)for(let fe=0;fe<P.__webglColorRenderbuffer.length;fe++)P.__webglColorRenderbuffer[fe]&&n.deleteRenderbuffer(P.__webglColorRenderbuffer[fe]);P.__webglDepthRenderbuffer&&n.deleteRenderbuffer(P.__webglDepthRenderbuffer)}let xe=O.textures;for(let fe=0,Se=xe.length;fe<Se;fe++){let we=i.get(xe[fe]);we.__webglTexture&&(n.deleteTexture(we.__webglTexture),o.memory.textures--),i.remove(xe[fe])}i.remove(O)}let q=0;function J(){q=0}function ne(){return q}function pe(O){q=O}function te(){let O=q;return O>=s.maxTextures&&je("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,O}function j(O){let P=[];return P.push(O.wrapS),P.push(O.wrapT),P.push(O.wrapR||0),P.push(O.magFilter),P.push(O.minFilter),P.push(O.anisotropy),P.push(O.internalFormat),P.push(O.format),P.push(O.type),P.push(O.generateMipmaps),P.push(O.mipmapsAutoUpdate),P.push(O.premultiplyAlpha),P.push(O.flipY),P.push(O.unpackAlignment),P.push(O.colorSpace),P.join()}function he(O,P){let Y=i.get(O);if(O.isVideoTexture&&$t(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&Y.__version!==O.version){let xe=O.image;if(xe===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(xe.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{Yt(Y,O,P);return}}else O.isExternalTexture&&(Y.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+P)}function me(O,P){let Y=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Y.__version!==O.version){Yt(Y,O,P);return}else O.isExternalTexture&&(Y.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+P)}function Q(O,P){let Y=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Y.__version!==O.version){Yt(Y,O,P);return}t.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+P)}function ue(O,P){let Y=i.get(O);if(O.version>0&&Y.__version!==O.version){gn(Y,O,P);return}t.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+P)}let Me={[su]:n.REPEAT,[vs]:n.CLAMP_TO_EDGE,[ru]:n.MIRRORED_REPEAT},We={[Hn]:n.NEAREST,[s_]:n.NEAREST_MIPMAP_NEAREST,[Cl]:n.NEAREST_MIPMAP_LINEAR,[hi]:n.LINEAR,[Iu]:n.LINEAR_MIPMAP_NEAREST,[Js]:n.LINEAR_MIPMAP_LINEAR},Ge={[l_]:n.NEVER,[qd]:n.ALWAYS,[c_]:n.LESS,[$d]:n.LEQUAL,[u_]:n.EQUAL,[Xd]:n.GEQUAL,[h_]:n.GREATER,[f_]:n.NOTEQUAL};function pt(O,P){if(P.type===Hi&&e.has("OES_texture_float_linear")===!1&&(P.magFilter===hi||P.magFilter===Iu||P.magFilter===Cl||P.magFilter===Js||P.minFilter===hi||P.minFilter===Iu||P.minFilter===Cl||P.minFilter===Js)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Me[P.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Me[P.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Me[P.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,We[P.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,We[P.minFilter]),P.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Ge[P.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(P.magFilter===Hn||P.minFilter!==Cl&&P.minFilter!==Js||P.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(P.anisotropy>1||i.get(P).__currentAnisotropy){let Y=e.get("EXT_texture_filter_anisotropic");n.texParameterf(O,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(P.anisotropy,s.getMaxAnisotropy())),i.get(P).__currentAnisotropy=P.anisotropy}}}function ht(O,P){let Y=!1;O.__webglInit===void 0&&(O.__webglInit=!0,P.addEventListener("dispose",I),R(P));let xe=P.source,fe=d.get(xe);fe===void 0&&(fe={},d.set(xe,fe));let Se=j(P);if(Se!==O.__cacheKey){fe[Se]===void 0&&(fe[Se]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),fe[Se].usedTimes++;let we=fe[O.__cacheKey];we!==void 0&&(fe[O.__cacheKey].usedTimes--,we.usedTimes===0&&k(P)),O.__cacheKey=Se,O.__webglTexture=fe[Se].texture}return Y}function ot(O,P,Y){return Math.floor(Math.floor(O/Y)/P)}function nn(O,P,Y,xe){let Se=O.updateRanges;if(Se.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,P.width,P.height,Y,xe,P.data);else{Se.sort((V,ce)=>V.start-ce.start);let we=0;for(let V=1;V<Se.length;V++){let ce=Se[we],oe=Se[V],Ce=ce.start+ce.count,be=ot(oe.start,P.width,4),Ae=ot(ce.start,P.width,4);oe.start<=Ce+1&&be===Ae&&ot(oe.start+oe.count-1,P.width,4)===be?ce.count=Math.max(ce.count,oe.start+oe.count-ce.start):(++we,Se[we]=oe)}Se.length=we+1;let re=t.getParameter(n.UNPACK_ROW_LENGTH),le=t.getParameter(n.UNPACK_SKIP_PIXELS),ve=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,P.width);for(let V=0,ce=Se.length;V<ce;V++){let oe=Se[V],Ce=Math.floor(oe.start/4),be=Math.ceil(oe.count/4),Ae=Ce%P.width,Xe=Math.floor(Ce/P.width),et=be,ge=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Ae,Xe,et,ge,Y,xe,P.data)}O.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,re),t.pixelStorei(n.UNPACK_SKIP_PIXELS,le),t.pixelStorei(n.UNPACK_SKIP_ROWS,ve)}}function Yt(O,P,Y){let xe=n.TEXTURE_2D;(P.isDataArrayTexture||P.isCompressedArrayTexture)&&(xe=n.TEXTURE_2D_ARRAY),P.isData3DTexture&&(xe=n.TEXTURE_3D);let fe=ht(O,P),Se=P.source;t.bindTexture(xe,O.__webglTexture,n.TEXTURE0+Y);let we=i.get(Se);if(Se.version!==we.__version||fe===!0){if(t.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&P.image instanceof ImageBitmap)===!1){let ge=bt.getPrimaries(bt.workingColorSpace),ze=P.colorSpace===Ks?null:bt.getPrimaries(P.colorSpace),tt=P.colorSpace===Ks||ge===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,P.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,P.unpackAlignment);let le=_(P.image,!1,s.maxTextureSize);le=$e(P,le);let ve=r.convert(P.format,P.colorSpace),V=r.convert(P.type),ce=b(P.internalFormat,ve,V,P.normalized,P.colorSpace,P.isVideoTexture);pt(xe,P);let oe,Ce=P.mipmaps,be=P.isVideoTexture!==!0,Ae=we.__version===void 0||fe===!0,Xe=Se.dataReady,et=w(P,le);if(P.isDepthTexture)ce=m(P.format===Zs,P.type),Ae&&(be?t.texStorage2D(n.TEXTURE_2D,1,ce,le.width,le.height):t.texImage2D(n.TEXTURE_2D,0,ce,le.width,le.height,0,ve,V,null));else if(P.isDataTexture)if(Ce.length>0){be&&Ae&&t.texStorage2D(n.TEXTURE_2D,et,ce,Ce[0].width,Ce[0].height);for(let ge=0,ze=Ce.length;ge<ze;ge++)oe=Ce[ge],be?Xe&&t.texSubImage2D(n.TEXTURE_2D,ge,0,0,oe.width,oe.height,ve,V,oe.data):t.texImage2D(n.TEXTURE_2D,ge,ce,oe.width,oe.height,0,ve,V,oe.data);P.generateMipmaps=!1}else be?(Ae&&t.texStorage2D(n.TEXTURE_2D,et,ce,le.width,le.height),Xe&&nn(P,le,ve,V)):t.texImage2D(n.TEXTURE_2D,0,ce,le.width,le.height,0,ve,V,le.data);else if(P.isCompressedTexture)if(P.isCompressedArrayTexture){be&&Ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ce,Ce[0].width,Ce[0].height,le.depth);for(let ge=0,ze=Ce.length;ge<ze;ge++)if(oe=Ce[ge],P.format!==is)if(ve!==null)if(be){if(Xe)if(P.layerUpdates.size>0){let tt=np(oe.width,oe.height,P.format,P.type);for(let Ie of P.layerUpdates){let ut=oe.data.subarray(Ie*tt/oe.data.BYTES_PER_ELEMENT,(Ie+1)*tt/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ge,0,0,Ie,oe.width,oe.height,1,ve,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ge,0,0,0,oe.width,oe.height,le.depth,ve,oe.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ge,ce,oe.width,oe.height,le.depth,0,oe.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else be?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ge,0,0,0,oe.width,oe.height,le.depth,ve,V,oe.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ge,ce,oe.width,oe.height,le.depth,0,ve,V,oe.data);P.layerUpdates.size>0&&P.clearLayerUpdates()}else{be&&Ae&&t.texStorage2D(n.TEXTURE_2D,et,ce,Ce[0].width,Ce[0].height);for(let ge=0,ze=Ce.length;ge<ze;ge++)oe=Ce[ge],P.format!==is?ve!==null?be?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ge,0,0,oe.width,oe.height,ve,oe.data):t.compressedTexImage2D(n.TEXTURE_2D,ge,ce,oe.width,oe.height,0,oe.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):be?Xe&&t.texSubImage2D(n.TEXTURE_2D,ge,0,0,oe.width,oe.height,ve,V,oe.data):t.texImage2D(n.TEXTURE_2D,ge,ce,oe.width,oe.height,0,ve,V,oe.data)}else if(P.isDataArrayTexture)if(be){if(Ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ce,le.width,le.height,le.depth),Xe)if(P.layerUpdates.size>0){let ge=np(le.width,le.height,P.format,P.type);for(let ze of P.layerUpdates){let tt=le.data.subarray(ze*ge/le.data.BYTES_PER_ELEMENT,(ze+1)*ge/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,le.width,le.height,1,ve,V,tt)}P.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,ve,V,le.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ce,le.width,le.height,le.depth,0,ve,V,le.data);else if(P.isData3DTexture)be?(Ae&&t.texStorage3D(n.TEXTURE_3D,et,ce,le.width,le.height,le.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,ve,V,le.data)):t.texImage3D(n.TEXTURE_3D,0,ce,le.width,le.height,le.depth,0,ve,V,le.data);else if(P.isFramebufferTexture){if(Ae)if(be)t.texStorage2D(n.TEXTURE_2D,et,ce,le.width,le.height);else{let ge=le.width,ze=le.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,ce,ge,ze,0,ve,V,null),ge>>=1,ze>>=1}}else if(P.isHTMLTexture){if("texElementImage2D"in n){let ge=n.canvas;if(ge.hasAttribute("layoutsubtree")||ge.setAttribute("layoutsubtree","true"),le.parentNode!==ge){ge.appendChild(le),h.add(P),ge.onpaint=ze=>{let tt=ze.changedElements;for(let Ie of h)tt.includes(Ie.image)&&(Ie.needsUpdate=!0)},ge.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,le);else{let tt=n.RGBA,Ie=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ie,ut,le)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(be&&Ae){let ge=Ye(Ce[0]);t.texStorage2D(n.TEXTURE_2D,et,ce,ge.width,ge.height)}for(let ge=0,ze=Ce.length;ge<ze;ge++)oe=Ce[ge],be?Xe&&t.texSubImage2D(n.TEXTURE_2D,ge,0,0,ve,V,oe):t.texImage2D(n.TEXTURE_2D,ge,ce,ve,V,oe);P.generateMipmaps=!1}else if(be){if(Ae){let ge=Ye(le);t.texStorage2D(n.TEXTURE_2D,et,ce,ge.width,ge.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,V,le)}else t.texImage2D(n.TEXTURE_2D,0,ce,ve,V,le);M(P)&&P.mipmapsAutoUpdate===!0&&S(xe),we.__version=Se.version,P.onUpdate&&P.onUpdate(P)}O.__version=P.version}function gn(O,P,Y){if(P.image.length!==6)return;let xe=ht(O,P),fe=P.source;t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+Y);let Se=i.get(fe);if(fe.version!==Se.__version||xe===!0){t.activeTexture(n.TEXTURE0+Y);let we=bt.getPrimaries(bt.workingColorSpace),re=P.colorSpace===Ks?null:bt.getPrimaries(P.colorSpace),le=P.colorSpace===Ks||we===re?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,P.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,P.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,le);let ve=P.isCompressedTexture||P.image[0].isCompressedTexture,V=P.image[0]&&P.image[0].isDataTexture,ce=[];for(let Ie=0;Ie<6;Ie++)!ve&&!V?ce[Ie]=_(P.image[Ie],!0,s.maxCubemapSize):ce[Ie]=V?P.image[Ie].image:P.image[Ie],ce[Ie]=$e(P,ce[Ie]);let oe=ce[0],Ce=r.convert(P.format,P.colorSpace),be=r.convert(P.type),Ae=b(P.internalFormat,Ce,be,P.normalized,P.colorSpace),Xe=P.isVideoTexture!==!0,et=Se.__version===void 0||xe===!0,ge=fe.dataReady,ze=w(P,oe);pt(n.TEXTURE_CUBE_MAP,P);let tt;if(P.isDepthTexture){if(Ae=m(P.format===Zs,P.type),et)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Ae,oe.width,oe.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,oe.width,oe.height,0,Ce,be,null)}else if(ve){Xe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Ae,oe.width,oe.height);for(let Ie=0;Ie<6;Ie++){tt=ce[Ie].mipmaps;for(let ut=0;ut<tt.length;ut++){let jt=tt[ut];P.format!==is?Ce!==null?Xe?ge&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,jt.width,jt.height,Ce,jt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Ae,jt.width,jt.height,0,jt.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ge&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,jt.width,jt.height,Ce,be,jt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Ae,jt.width,jt.height,0,Ce,be,jt.data)}}}else{if(tt=P.mipmaps,Xe&&et){tt.length>0&&ze++;let Ie=Ye(ce[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Ae,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(V){Xe?ge&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,ce[Ie].width,ce[Ie].height,Ce,be,ce[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,ce[Ie].width,ce[Ie].height,0,Ce,be,ce[Ie].data);for(let ut=0;ut<tt.length;ut++){let oi=tt[ut].image[Ie].image;Xe?ge&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,oi.width,oi.height,Ce,be,oi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Ae,oi.width,oi.height,0,Ce,be,oi.data)}}else{Xe?ge&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Ce,be,ce[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,Ce,be,ce[Ie]);for(let ut=0;ut<tt.length;ut++){let jt=tt[ut];Xe?ge&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Ce,be,jt.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Ae,Ce,be,jt.image[Ie])}}}M(P)&&P.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),Se.__version=fe.version,P.onUpdate&&P.onUpdate(P)}O.__version=P.version}function Gt(O,P,Y,xe,fe,Se){let we=r.convert(Y.format,Y.colorSpace),re=r.convert(Y.type),le=b(Y.internalFormat,we,re,Y.normalized,Y.colorSpace),ve=i.get(P),V=i.get(Y);if(V.__renderTarget=P,!ve.__hasExternalTextures){let ce=Math.max(1,P.width>>Se),oe=Math.max(1,P.height>>Se);fe===n.TEXTURE_3D||fe===n.TEXTURE_2D_ARRAY?t.texImage3D(fe,Se,le,ce,oe,P.depth,0,we,re,null):t.texImage2D(fe,Se,le,ce,oe,0,we,re,null)}t.bindFramebuffer(n.FRAMEBUFFER,O),Ee(P)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,fe,V.__webglTexture,0,lt(P)):(fe===n.TEXTURE_2D||fe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&fe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,xe,fe,V.__webglTexture,Se),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fn(O,P,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,O),P.depthBuffer){let xe=P.depthTexture,fe=xe&&xe.isDepthTexture?xe.type:null,Se=m(P.stencilBuffer,fe),we=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(P)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(P),Se,P.width,P.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(P),Se,P.width,P.height):n.renderbufferStorage(n.RENDERBUFFER,Se,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,we,n.RENDERBUFFER,O)}else{let xe=P.textures;for(let fe=0;fe<xe.length;fe++){let Se=xe[fe],we=r.convert(Se.format,Se.colorSpace),re=r.convert(Se.type),le=b(Se.internalFormat,we,re,Se.normalized,Se.colorSpace);Ee(P)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(P),le,P.width,P.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(P),le,P.width,P.height):n.renderbufferStorage(n.RENDERBUFFER,le,P.width,P.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Tt(O,P,Y){let xe=P.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,O),!(P.depthTexture&&P.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let fe=i.get(P.depthTexture);fe.__renderTarget=P;let Se=xe?P.depthTexture.image[0]:P.depthTexture.image;(!fe.__webglTexture||Se.width!==P.width||Se.height!==P.height)&&(Se.width=P.width,Se.height=P.height,P.depthTexture.needsUpdate=!0),xe?ue(P.depthTexture,0):he(P.depthTexture,0);let we=fe.__webglTexture,re=lt(P),le=xe?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,ve=P.depthTexture.format===Zs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(P.depthTexture.format===Hs)Ee(P)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ve,le,we,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,ve,le,we,0);else if(P.depthTexture.format===Zs)Ee(P)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ve,le,we,0,re):n.framebufferTexture2D(n.FRAMEBUFFER,ve,le,we,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function En(O){let P=i.get(O),Y=O.isWebGLCubeRenderTarget===!0;if(P.__boundDepthTexture!==O.depthTexture){let xe=O.depthTexture;if(P.__depthDisposeCallback&&P.__depthDisposeCallback(),xe){let fe=()=>{delete P.__boundDepthTexture,delete P.__depthDisposeCallback,xe.removeEventListener("dispose",fe)};xe.addEventListener("dispose",fe),P.__depthDisposeCallback=fe}P.__boundDepthTexture=xe}if(O.depthTexture&&!P.__autoAllocateDepthBuffer)if(Y)for(let xe=0;xe<6;xe++)Tt(P.__webglFramebuffer[xe],O,xe);else O.texture.mipmaps.length>0?Tt(P.__webglFramebuffer[0],O,0):Tt(P.__webglFramebuffer,O,0);else if(Y){P.__webglDepthbuffer=[];for(let xe=0;xe<6;xe++)if(t.bindFramebuffer(n.FRAMEBUFFER,P.__webglFramebuffer[xe]),P.__webglDepthbuffer[xe]===void 0)P.__webglDepthbuffer[xe]=n.createRenderbuffer(),Fn(P.__webglDepthbuffer[xe],O,!1);else{let fe=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=P.__webglDepthbuffer[xe];n.bindRenderbuffer(n.RENDERBUFFER,Se),n.framebufferRenderbuffer(n.FRAMEBUFFER,fe,n.RENDERBUFFER,Se)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,P.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,P.__webglFramebuffer),P.__webglDepthbuffer===void 0)P.__webglDepthbuffer=n.createRenderbuffer(),Fn(P.__webglDepthbuffer,O,!1);else{let fe=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=P.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,Se),n.framebufferRenderbuffer(n.FRAMEBUFFER,fe,n.RENDERBUFFER,Se)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function on(O,P,Y){let xe=i.get(O);P!==void 0&&Gt(xe.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&En(O)}function _n(O){let P=O.texture,Y=i.get(O),xe=i.get(P);O.addEventListener("dispose",E),R(O);let fe=O.textures,Se=O.isWebGLCubeRenderTarget===!0,we=fe.length>1;if(we||(xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture()),xe.__version=P.version,o.memory.textures++),Se){Y.__webglFramebuffer=[];for(let re=0;re<6;re++)if(P.mipmaps.length>0){Y.__webglFramebuffer[re]=[];for(let le=0;le<P.mipmaps.length;le++)Y.__webglFramebuffer[re][le]=n.createFramebuffer()}else Y.__webglFramebuffer[re]=n.createFramebuffer()}else{if(P.mipmaps.length>0){Y.__webglFramebuffer=[];for(let re=0;re<P.mipmaps.length;re++)Y.__webglFramebuffer[re]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(we)for(let re=0,le=fe.length;re<le;re++){let ve=i.get(fe[re]);ve.__webglTexture===void 0&&(ve.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Ee(O)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let re=0;re<fe.length;re++){let le=fe[re];Y.__webglColorRenderbuffer[re]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[re]);let ve=r.convert(le.format,le.colorSpace),V=r.convert(le.type),ce=b(le.internalFormat,ve,V,le.normalized,le.colorSpace,O.isXRRenderTarget===!0),oe=lt(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,oe,ce,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+re,n.RENDERBUFFER,Y.__webglColorRenderbuffer[re])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),Fn(Y.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(Se){t.bindTexture(n.TEXTURE_CUBE_MAP,xe.__webglTexture),pt(n.TEXTURE_CUBE_MAP,P);for(let re=0;re<6;re++)if(P.mipmaps.length>0)for(let le=0;le<P.mipmaps.length;le++)Gt(Y.__webglFramebuffer[re][le],O,P,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,le);else Gt(Y.__webglFramebuffer[re],O,P,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0);M(P)?S(n.TEXTURE_CUBE_MAP):P.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,P.mipmaps.length-1),t.unbindTexture()}else if(we){for(let re=0,le=fe.length;re<le;re++){let ve=fe[re],V=i.get(ve),ce=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ce=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ce,V.__webglTexture),pt(ce,ve),Gt(Y.__webglFramebuffer,O,ve,n.COLOR_ATTACHMENT0+re,ce,0),M(ve)&&S(ce)}t.unbindTexture()}else{let re=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(re=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,xe.__webglTexture),pt(re,P),P.mipmaps.length>0)for(let le=0;le<P.mipmaps.length;le++)Gt(Y.__webglFramebuffer[le],O,P,n.COLOR_ATTACHMENT0,re,le);else Gt(Y.__webglFramebuffer,O,P,n.COLOR_ATTACHMENT0,re,0);M(P)?S(re):P.mipmaps.length>0&&n.texParameteri(re,n.TEXTURE_MAX_LEVEL,P.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&En(O)}function G(O){let P=O.textures;for(let Y=0,xe=P.length;Y<xe;Y++){let fe=P[Y];if(M(fe)&&fe.mipmapsAutoUpdate===!0){let Se=T(O),we=i.get(fe).__webglTexture;t.bindTexture(Se,we),S(Se),t.unbindTexture()}}}let Le=[];function Ze(O){if(O.samples>0){if(Ee(O)===!1){let P=O.textures,Y=O.width,xe=O.height,fe=n.COLOR_BUFFER_BIT,Se=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,we=i.get(O),re=P.length>1;if(re)for(let ve=0;ve<P.length;ve++)t.bindFramebuffer(n.FRAMEBUFFER,we.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,we.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,we.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,we.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,we.__webglFramebuffer);for(let ve=0;ve<P.length;ve++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(fe|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(fe|=n.STENCIL_BUFFER_BIT)),re){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,we.__webglColorRenderbuffer[ve]);let V=i.get(P[ve]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,Y,xe,0,0,Y,xe,fe,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+ve),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Le.push(Se),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),re)for(let ve=0;ve<P.length;ve++){t.bindFramebuffer(n.FRAMEBUFFER,we.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.RENDERBUFFER,we.__webglColorRenderbuffer[ve]);let V=i.get(P[ve]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,we.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.TEXTURE_2D,V,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,we.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let P=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[P])}}}function lt(O){return Math.min(s.maxSamples,O.samples)}function Ee(O){let P=i.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&P.__useRenderToTexture!==!1}function $t(O){let P=o.render.frame;u.get(O)!==P&&(u.set(O,P),O.update())}function $e(O,P){let Y=O.colorSpace,xe=O.format,fe=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||Y!==rl&&Y!==Ks&&(bt.getTransfer(Y)===Dt?(xe!==is||fe!==gi)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",Y)),P}function Ye(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=te,this.resetTextureUnits=J,this.getTextureUnits=ne,this.setTextureUnits=pe,this.setTexture2D=he,this.setTexture2DArray=me,this.setTexture3D=Q,this.setTextureCube=ue,this.rebindTextures=on,this.setupRenderTarget=_n,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=En,this.setupFrameBufferTexture=Gt,this.useMultisampledRTT=Ee,this.dispose=z}function KA(n,e){function t(i,s=Ks){let r,o=bt.getTransfer(s);if(i===gi)return n.UNSIGNED_BYTE;if(i===Nu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Du)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Vd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Gd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===kd)return n.BYTE;if(i===zd)return n.SHORT;if(i===ca)return n.UNSIGNED_SHORT;if(i===Lu)return n.INT;if(i===ts)return n.UNSIGNED_INT;if(i===Hi)return n.FLOAT;if(i===ns)return n.HALF_FLOAT;if(i===Hd)return n.ALPHA;if(i===Wd)return n.RGB;if(i===is)return n.RGBA;if(i===Hs)return n.DEPTH_COMPONENT;if(i===Zs)return n.DEPTH_STENCIL;if(i===Fu)return n.RED;if(i===Ou)return n.RED_INTEGER;if(i===Er)return n.RG;if(i===Uu)return n.RG_INTEGER;if(i===Bu)return n.RGBA_INTEGER;if(i===Rl||i===Pl||i===Il||i===Ll)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Il)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ku||i===zu||i===Vu||i===Gu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ku)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===zu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Vu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Gu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Hu||i===Wu||i===$u||i===Xu||i===qu||i===Nl||i===Yu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Hu||i===Wu)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===$u)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Xu)return r.COMPRESSED_R11_EAC;if(i===qu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Nl)return r.COMPRESSED_RG11_EAC;if(i===Yu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ju||i===Ju||i===Zu||i===Ku||i===Qu||i===eh||i===th||i===nh||i===ih||i===sh||i===rh||i===oh||i===ah||i===lh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ju)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ju)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Zu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ku)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Qu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===eh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===th)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===nh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===ih)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===sh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===rh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===oh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===ah)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===lh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ch||i===uh||i===hh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===ch)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===hh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===fh||i===dh||i===Dl||i===ph)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===fh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===dh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Dl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ph)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===eo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var QA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,eE=`
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

}`,hp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new _l(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Gi({vertexShader:QA,fragmentShader:eE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Tn(new xl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},fp=class extends Qi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,y=null,v=typeof XRWebGLBinding<"u",g=new hp,x={},_=t.getContextAttributes(),M=null,S=null,T=[],b=[],m=new Qe,w=null,R=null,C=new Ci;C.viewport=new Wt;let I=new Ci;I.viewport=new Wt;let E=[C,I],F=new Eu,D=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let he=T[j];return he===void 0&&(he=new ta,T[j]=he),he.getTargetRaySpace()},this.getControllerGrip=function(j){let he=T[j];return he===void 0&&(he=new ta,T[j]=he),he.getGripSpace()},this.getHand=function(j){let he=T[j];return he===void 0&&(he=new ta,T[j]=he),he.getHandSpace()};function X(j){let he=b.indexOf(j.inputSource);if(he===-1)return;let me=T[he];me!==void 0&&(me.update(j.inputSource,j.frame,c||o),me.dispatchEvent({type:j.type,data:j.inputSource}))}function k(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",se);for(let j=0;j<T.length;j++){let he=b[j];he!==null&&(b[j]=null,T[j].disconnect(he))}D=null,z=null,g.reset();for(let j in x)delete x[j];if(e.setRenderTarget(M),d=null,f=null,h=null,s=null,S=null,te.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(m.width,m.height,!1),R!==null){let j=R.camera;j.fov=R.fov,j.zoom=R.zoom,j.updateProjectionMatrix(),R=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return y},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",k),s.addEventListener("inputsourceschange",se),_.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(m),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,Q=null,ue=null;_.depth&&(ue=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=_.stencil?Zs:Hs,Q=_.stencil?eo:ts);let Me={colorFormat:t.RGBA8,depthFormat:ue,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Me),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new Ri(f.textureWidth,f.textureHeight,{format:is,type:gi,depthTexture:new js(f.textureWidth,f.textureHeight,Q,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let me={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new Ri(d.framebufferWidth,d.framebufferHeight,{format:is,type:gi,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),te.setContext(s),te.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function se(j){for(let he=0;he<j.removed.length;he++){let me=j.removed[he],Q=b.indexOf(me);Q>=0&&(b[Q]=null,T[Q].disconnect(me))}for(let he=0;he<j.added.length;he++){let me=j.added[he],Q=b.indexOf(me);if(Q===-1){for(let Me=0;Me<T.length;Me++)if(Me>=b.length){b.push(me),Q=Me;break}else if(b[Me]===null){b[Me]=me,Q=Me;break}if(Q===-1)break}let ue=T[Q];ue&&ue.connect(me)}}function q(j,he){he===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(he.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let he=j.near,me=j.far;g.texture!==null&&(g.depthNear>0&&(he=g.depthNear),g.depthFar>0&&(me=g.depthFar)),F.near=I.near=C.near=he,F.far=I.far=C.far=me,(D!==F.near||z!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),D=F.near,z=F.far),F.layers.mask=j.layers.mask|6,C.layers.mask=F.layers.mask&-5,I.layers.mask=F.layers.mask&-3;let Q=j.parent,ue=F.cameras;q(F,Q);for(let Me=0;Me<ue.length;Me++)q(ue[Me],Q);F.projectionMatrix.copy(C.projectionMatrix),F.projectionMatrixInverse.copy(C.projectionMatrixInverse),R===null&&j.isPerspectiveCamera&&(R={camera:j,fov:j.fov,zoom:j.zoom}),J(j,F,Q)};function J(j,he,me){me===null?j.matrix.copy(he.matrixWorld):(j.matrix.copy(me.matrixWorld),j.matrix.invert(),j.matrix.multiply(he.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(he.projectionMatrix),j.projectionMatrixInverse.copy(he.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=Ko*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(F)},this.getCameraTexture=function(j){return x[j]};let ne=null;function pe(j,he){if(u=he.getViewerPose(c||o),y=he,u!==null){let me=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Q=!1;me.length!==F.cameras.length&&(F.cameras.length=0,Q=!0);for(let Ge=0;Ge<me.length;Ge++){let pt=me[Ge],ht=null;if(d!==null)ht=d.getViewport(pt);else{let nn=h.getViewSubImage(f,pt);ht=nn.viewport,Ge===0&&(e.setRenderTargetTextures(S,nn.colorTexture,nn.depthStencilTexture),e.setRenderTarget(S))}let ot=E[Ge];ot===void 0&&(ot=new Ci,ot.layers.enable(Ge),ot.viewport=new Wt,E[Ge]=ot),ot.matrix.fromArray(pt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(pt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ht.x,ht.y,ht.width,ht.height),Ge===0&&(F.matrix.copy(ot.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),Q===!0&&F.cameras.push(ot)}let ue=s.enabledFeatures;if(ue&&ue.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let Ge=h.getDepthInformation(me[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(ue&&ue.includes("camera-access")&&v){e.state.unbindTexture(),h=i.getBinding();for(let Ge=0;Ge<me.length;Ge++){let pt=me[Ge].camera;if(pt){let ht=x[pt];ht||(ht=new _l,x[pt]=ht);let ot=h.getCameraImage(pt);ht.sourceTexture=ot}}}}for(let me=0;me<T.length;me++){let Q=b[me],ue=T[me];Q!==null&&ue!==void 0&&ue.update(Q,he,c||o)}ne&&ne(j,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),y=null}let te=new $_;te.setAnimationLoop(pe),this.setAnimationLoop=function(j){ne=j},this.dispose=function(){}}},tE=new Je,tx=new it;tx.set(-1,0,0,0,1,0,0,0,1);function nE(n,e){function t(g,x){g.matrixAutoUpdate===!0&&g.updateMatrix(),x.value.copy(g.matrix)}function i(g,x){x.color.getRGB(g.fogColor.value,Qd(n)),x.isFog?(g.fogNear.value=x.near,g.fogFar.value=x.far):x.isFogExp2&&(g.fogDensity.value=x.density)}function s(g,x,_,M,S){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(g,x):x.isMeshLambertMaterial?(r(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(g,x),h(g,x)):x.isMeshPhongMaterial?(r(g,x),u(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(g,x),f(g,x),x.isMeshPhysicalMaterial&&d(g,x,S)):x.isMeshMatcapMaterial?(r(g,x),y(g,x)):x.isMeshDepthMaterial?r(g,x):x.isMeshDistanceMaterial?(r(g,x),v(g,x)):x.isMeshNormalMaterial?r(g,x):x.isLineBasicMaterial?(o(g,x),x.isLineDashedMaterial&&a(g,x)):x.isPointsMaterial?l(g,x,_,M):x.isSpriteMaterial?c(g,x):x.isShadowMaterial?(g.color.value.copy(x.color),g.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(g,x){g.opacity.value=x.opacity,x.color&&g.diffuse.value.copy(x.color),x.emissive&&g.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(g.map.value=x.map,t(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.bumpMap&&(g.bumpMap.value=x.bumpMap,t(x.bumpMap,g.bumpMapTransform),g.bumpScale.value=x.bumpScale,x.side===fi&&(g.bumpScale.value*=-1)),x.normalMap&&(g.normalMap.value=x.normalMap,t(x.normalMap,g.normalMapTransform),g.normalScale.value.copy(x.normalScale),x.side===fi&&g.normalScale.value.negate()),x.displacementMap&&(g.displacementMap.value=x.displacementMap,t(x.displacementMap,g.displacementMapTransform),g.displacementScale.value=x.displacementScale,g.displacementBias.value=x.displacementBias),x.emissiveMap&&(g.emissiveMap.value=x.emissiveMap,t(x.emissiveMap,g.emissiveMapTransform)),x.specularMap&&(g.specularMap.value=x.specularMap,t(x.specularMap,g.specularMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest);let _=e.get(x),M=_.envMap,S=_.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(tE.makeRotationFromEuler(S)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(tx),g.reflectivity.value=x.reflectivity,g.ior.value=x.ior,g.refractionRatio.value=x.refractionRatio),x.lightMap&&(g.lightMap.value=x.lightMap,g.lightMapIntensity.value=x.lightMapIntensity,t(x.lightMap,g.lightMapTransform)),x.aoMap&&(g.aoMap.value=x.aoMap,g.aoMapIntensity.value=x.aoMapIntensity,t(x.aoMap,g.aoMapTransform))}function o(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,x.map&&(g.map.value=x.map,t(x.map,g.mapTransform))}function a(g,x){g.dashSize.value=x.dashSize,g.totalSize.value=x.dashSize+x.gapSize,g.scale.value=x.scale}function l(g,x,_,M){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.size.value=x.size*_,g.scale.value=M*.5,x.map&&(g.map.value=x.map,t(x.map,g.uvTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function c(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.rotation.value=x.rotation,x.map&&(g.map.value=x.map,t(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function u(g,x){g.specular.value.copy(x.specular),g.shininess.value=Math.max(x.shininess,1e-4)}function h(g,x){x.gradientMap&&(g.gradientMap.value=x.gradientMap)}function f(g,x){g.metalness.value=x.metalness,x.metalnessMap&&(g.metalnessMap.value=x.metalnessMap,t(x.metalnessMap,g.metalnessMapTransform)),g.roughness.value=x.roughness,x.roughnessMap&&(g.roughnessMap.value=x.roughnessMap,t(x.roughnessMap,g.roughnessMapTransform)),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)}function d(g,x,_){g.ior.value=x.ior,x.diffuseRoughness>0&&(g.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=x.diffuseRoughnessMap,t(x.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),x.sheen>0&&(g.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),g.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(g.sheenColorMap.value=x.sheenColorMap,t(x.sheenColorMap,g.sheenColorMapTransform)),x.sheenRoughnessMap&&(g.sheenRoughnessMap.value=x.sheenRoughnessMap,t(x.sheenRoughnessMap,g.sheenRoughnessMapTransform))),x.clearcoat>0&&(g.clearcoat.value=x.clearcoat,g.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(g.clearcoatMap.value=x.clearcoatMap,t(x.clearcoatMap,g.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,t(x.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(g.clearcoatNormalMap.value=x.clearcoatNormalMap,t(x.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===fi&&g.clearcoatNormalScale.value.negate())),x.dispersion>0&&(g.dispersion.value=x.dispersion),x.retroreflectivity>0&&(g.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(g.iridescence.value=x.iridescence,g.iridescenceIOR.value=x.iridescenceIOR,g.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(g.iridescenceMap.value=x.iridescenceMap,t(x.iridescenceMap,g.iridescenceMapTransform)),x.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=x.iridescenceThicknessMap,t(x.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),x.transmission>0&&(g.transmission.value=x.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),x.transmissionMap&&(g.transmissionMap.value=x.transmissionMap,t(x.transmissionMap,g.transmissionMapTransform)),g.thickness.value=x.thickness,x.thicknessMap&&(g.thicknessMap.value=x.thicknessMap,t(x.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=x.attenuationDistance,g.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(g.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(g.anisotropyMap.value=x.anisotropyMap,t(x.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=x.specularIntensity,g.specularColor.value.copy(x.specularColor),x.specularColorMap&&(g.specularColorMap.value=x.specularColorMap,t(x.specularColorMap,g.specularColorMapTransform)),x.specularIntensityMap&&(g.specularIntensityMap.value=x.specularIntensityMap,t(x.specularIntensityMap,g.specularIntensityMapTransform))}function y(g,x){x.matcap&&(g.matcap.value=x.matcap)}function v(g,x){let _=e.get(x).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function iE(n,e,t,i){let s={},r={};function o(_,M){let S=M.program;i.uniformBlockBinding(_,S,s[_.id])}function a(_,M){let S=s[_.id];S===void 0&&(y(_),S=l(_),s[_.id]=S,_.addEventListener("dispose",g));let T=M.program;i.updateUBOMapping(_,T);let b=e.render.frame;r[_.id]!==b&&(c(_),r[_.id]=b)}function l(_){let M=n.createBuffer(),S=_.__size,T=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,S,T),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(_){let M=s[_.id],S=_.uniforms,T=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let b=0,m=S.length;b<m;b++){let w=S[b];if(Array.isArray(w))for(let R=0,C=w.length;R<C;R++)u(w[R],b,R,T);else u(w,b,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,M,S,T){if(f(_,M,S,T)===!0){let b=_.__offset,m=_.value;if(Array.isArray(m)){let w=0;for(let R=0;R<m.length;R++){let C=m[R],I=v(C,!0);h(C,_.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(m,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,b,_.__data)}}function h(_,M,S){typeof _=="number"||typeof _=="boolean"?M[S]=_:_.isMatrix3?(M[S]=_.elements[0],M[S+1]=_.elements[1],M[S+2]=_.elements[2],M[S+3]=0,M[S+4]=_.elements[3],M[S+5]=_.elements[4],M[S+6]=_.elements[5],M[S+7]=0,M[S+8]=_.elements[6],M[S+9]=_.elements[7],M[S+10]=_.elements[8],M[S+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-S),S):_.toArray(M,S)}function f(_,M,S,T){let b=_.value,m=M+"_"+S;if(Array.isArray(b)){T[m]===void 0&&(T[m]=[]);let w=T[m],R=!1;for(let C=0;C<b.length;C++)d(b[C],w,C)===!0&&(R=!0);return R}return d(b,T,m)}function d(_,M,S){if(M[S]===void 0)return typeof _=="number"||typeof _=="boolean"?M[S]=_:ArrayBuffer.isView(_)?M[S]=_.slice():M[S]=_.clone(),!0;{let T=M[S];if(typeof _=="number"||typeof _=="boolean"){if(T!==_)return M[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(T.equals(_)===!1)return T.copy(_),!0}}return!1}function y(_){let M=_.uniforms,S=0,T=16;for(let m=0,w=M.length;m<w;m++){let R=Array.isArray(M[m])?M[m]:[M[m]];for(let C=0,I=R.length;C<I;C++){let E=R[C],F=Array.isArray(E.value)?E.value:[E.value],D=Array.isArray(M[m])||Array.isArray(E.value),z=S;for(let k=0,se=F.length;k<se;k++){let q=F[k],J=v(q,D),ne=S%T,pe=ne%J.boundary,te=ne+pe;S+=pe,te!==0&&T-te<J.storage&&(S+=T-te),k===0&&(z=S),S+=J.storage}let X=E.type==="int"?Int32Array:E.type==="uint"?Uint32Array:Float32Array;E.__data=new X((S-z)/Float32Array.BYTES_PER_ELEMENT),E.__offset=z}}let b=S%T;return b>0&&(S+=T-b),_.__size=S,_.__cache={},this}function v(_,M){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):je("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(_){let M=_.target;M.removeEventListener("dispose",g),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function x(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:x}}var sE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ms=null;function rE(){return Ms===null&&(Ms=new Ys(sE,16,16,Er,ns),Ms.name="DFG_LUT",Ms.minFilter=hi,Ms.magFilter=hi,Ms.wrapS=vs,Ms.wrapT=vs,Ms.generateMipmaps=!1,Ms.needsUpdate=!0),Ms}var Ts=class{constructor(e={}){let{canvas:t=p_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=gi}=e;this.isWebGLRenderer=!0;let y;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");y=i.getContextAttributes().alpha}else y=o;let v=d,g=new Set([Bu,Uu,Ou]),x=new Set([gi,ts,ca,eo,Nu,Du]),_=new Uint32Array(4),M=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},T=null,b=null,m=[],w=[],R=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ss,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,I=!1,E=null,F=null,D=null,z=null;this._outputColorSpace=ni;let X=0,k=0,se=null,q=-1,J=null,ne=new Wt,pe=new Wt,te=null,j=new rt(0),he=0,me=t.width,Q=t.height,ue=1,Me=null,We=null,Ge=new Wt(0,0,me,Q),pt=new Wt(0,0,me,Q),ht=!1,ot=new vr,nn=new uu,Yt=!1,gn=!1,Gt=new Je,Fn=new H,Tt=new Wt,En={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},on=!1;function _n(){return se===null?ue:1}let G=i;function Le(N,W){return t.getContext(N,W)}let Ze,lt,Ee,$t,$e,Ye,O,P,Y,xe,fe,Se,we,re,le,ve,V,ce,oe,Ce,be,Ae,Xe;try{let N={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),G===null){let W="webgl2";if(G=Le(W,N),G===null)throw Le(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(N){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),nt("WebGLRenderer: "+N.message),N}function et(){Ze=new gT(G),Ze.init(),be=new KA(G,Ze),lt=new rT(G,Ze,e,be),Ee=new JA(G,Ze),lt.reversedDepthBuffer&&f&&Ee.buffers.depth.setReversed(!0),F=G.createFramebuffer(),D=G.createFramebuffer(),z=G.createFramebuffer(),$t=new yT(G),$e=new OA,Ye=new ZA(G,Ze,Ee,$e,lt,be,$t),O=new mT(C),P=new bM(G),Ae=new iT(G,P),Y=new _T(G,P,$t,Ae),xe=new bT(G,Y,P,Ae,$t),ce=new vT(G,lt,Ye),le=new oT($e),fe=new FA(C,O,Ze,lt,Ae,le),Se=new nE(C,$e),we=new BA,re=new WA(Ze),V=new nT(C,O,Ee,xe,y,l),ve=new jA(C,xe,lt),Xe=new iE(G,$t,lt,Ee),oe=new sT(G,Ze,$t),Ce=new xT(G,Ze,$t),$t.programs=fe.programs,C.capabilities=lt,C.extensions=Ze,C.properties=$e,C.renderLists=we,C.shadowMap=ve,C.state=Ee,C.info=$t}v!==gi&&(R=new MT(v,t.width,t.height,a,s,r));let ge=new fp(C,G);this.xr=ge,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let N=Ze.get("WEBGL_lose_context");N&&N.loseContext()},this.forceContextRestore=function(){let N=Ze.get("WEBGL_lose_context");N&&N.restoreContext()},this.getPixelRatio=function(){return ue},this.setPixelRatio=function(N){N!==void 0&&(ue=N,this.setSize(me,Q,!1))},this.getSize=function(N){return N.set(me,Q)},this.setSize=function(N,W,ie=!0){if(ge.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}me=N,Q=W,t.width=Math.floor(N*ue),t.height=Math.floor(W*ue),ie===!0&&(t.style.width=N+"px",t.style.height=W+"px"),R!==null&&R.setSize(t.width,t.height),this.setViewport(0,0,N,W)},this.getDrawingBufferSize=function(N){return N.set(me*ue,Q*ue).floor()},this.setDrawingBufferSize=function(N,W,ie){me=N,Q=W,ue=ie,t.width=Math.floor(N*ie),t.height=Math.floor(W*ie),this.setViewport(0,0,N,W)},this.setEffects=function(N){if(v===gi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(N){for(let W=0;W<N.length;W++)if(N[W].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}R.setEffects(N||[])},this.getCurrentViewport=function(N){return N.copy(ne)},this.getViewport=function(N){return N.copy(Ge)},this.setViewport=function(N,W,ie,Z){N.isVector4?Ge.set(N.x,N.y,N.z,N.w):Ge.set(N,W,ie,Z),Ee.viewport(ne.copy(Ge).multiplyScalar(_n()).round())},this.getScissor=function(N){return N.copy(pt)},this.setScissor=function(N,W,ie,Z){N.isVector4?pt.set(N.x,N.y,N.z,N.w):pt.set(N,W,ie,Z),Ee.scissor(pe.copy(pt).multiplyScalar(_n()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(N){Ee.setScissorTest(ht=N)},this.setOpaqueSort=function(N){Me=N},this.setTransparentSort=function(N){We=N},this.getClearColor=function(N){return N.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(N=!0,W=!0,ie=!0){let Z=0;if(N){let K=!1;if(se!==null){let Re=se.texture.format;K=g.has(Re)}if(K){let Re=se.texture.type,Ne=x.has(Re),Pe=V.getClearColor(),De=V.getClearAlpha(),He=Pe.r,st=Pe.g,gt=Pe.b;Ne?(_[0]=He,_[1]=st,_[2]=gt,_[3]=De,G.clearBufferuiv(G.COLOR,0,_)):(M[0]=He,M[1]=st,M[2]=gt,M[3]=De,G.clearBufferiv(G.COLOR,0,M))}else Z|=G.COLOR_BUFFER_BIT}W&&(Z|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ie&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(N){N.setRenderer(this),E=N},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),V.dispose(),we.dispose(),re.dispose(),Ye.dispose(),$e.dispose(),O.dispose(),xe.dispose(),Y.dispose(),Ae.dispose(),Xe.dispose(),fe.dispose(),ge.dispose(),ge.removeEventListener("sessionstart",ic),ge.removeEventListener("sessionend",cs),Ps.stop()};function ze(N){N.preventDefault(),jd("WebGLRenderer: Context Lost."),I=!0}function tt(){jd("WebGLRenderer: Context Restored."),I=!1;let N=$t.autoReset,W=ve.enabled,ie=ve.autoUpdate,Z=ve.needsUpdate,K=ve.type;et(),$t.autoReset=N,ve.enabled=W,ve.autoUpdate=ie,ve.needsUpdate=Z,ve.type=K}function Ie(N){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",N.statusMessage)}function ut(N){let W=N.target;W.removeEventListener("dispose",ut),jt(W)}function jt(N){oi(N),$e.remove(N)}function oi(N){let W=$e.get(N).programs;W!==void 0&&(W.forEach(function(ie){fe.releaseProgram(ie)}),N.isShaderMaterial&&fe.releaseShaderCache(N))}this.renderBufferDirect=function(N,W,ie,Z,K,Re){W===null&&(W=En);let Ne=K.isMesh&&K.matrixWorld.determinantAffine()<0,Pe=Oa(N,W,ie,Z,K);Ee.setMaterial(Z,Ne);let De=ie.index,He=1;if(Z.wireframe===!0){if(De=Y.getWireframeAttribute(ie),De===void 0)return;He=2}let st=ie.drawRange,gt=ie.attributes.position,Ve=st.start*He,_t=(st.start+st.count)*He;Re!==null&&(Ve=Math.max(Ve,Re.start*He),_t=Math.min(_t,(Re.start+Re.count)*He)),De!==null?(Ve=Math.max(Ve,0),_t=Math.min(_t,De.count)):gt!=null&&(Ve=Math.max(Ve,0),_t=Math.min(_t,gt.count));let rn=_t-Ve;if(rn<0||rn===1/0)return;Ae.setup(K,Z,Pe,ie,De);let Ut,Bt=oe;if(De!==null&&(Ut=P.get(De),Bt=Ce,Bt.setIndex(Ut)),K.isMesh)Z.wireframe===!0?(Ee.setLineWidth(Z.wireframeLinewidth*_n()),Bt.setMode(G.LINES)):Bt.setMode(G.TRIANGLES);else if(K.isLine){let Cn=Z.linewidth;Cn===void 0&&(Cn=1),Ee.setLineWidth(Cn*_n()),K.isLineSegments?Bt.setMode(G.LINES):K.isLineLoop?Bt.setMode(G.LINE_LOOP):Bt.setMode(G.LINE_STRIP)}else K.isPoints?Bt.setMode(G.POINTS):K.isSprite&&Bt.setMode(G.TRIANGLES);if(K.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Bt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Cn=K._multiDrawStarts,Be=K._multiDrawCounts,xn=K._multiDrawCount,yt=De?P.get(De).bytesPerElement:1,Ls=$e.get(Z).currentProgram.getUniforms();for(let yn=0;yn<xn;yn++)Ls.setValue(G,"_gl_DrawID",yn),Bt.render(Cn[yn]/yt,Be[yn])}else if(K.isInstancedMesh)Bt.renderInstances(Ve,rn,K.count);else if(ie.isInstancedBufferGeometry){let Cn=ie._maxInstanceCount!==void 0?ie._maxInstanceCount:1/0,Be=Math.min(ie.instanceCount,Cn);Bt.renderInstances(Ve,rn,Be)}else Bt.render(Ve,rn)};function Na(N,W,ie,Z){E!==null&&N.isNodeMaterial&&E.setObject(Z,N),Yt===!0&&le.setState(N,ie,!1),N.transparent===!0&&N.side===mi&&N.forceSinglePass===!1?(N.side=fi,N.needsUpdate=!0,us(N,W,Z),N.side=Ar,N.needsUpdate=!0,us(N,W,Z),N.side=mi):us(N,W,Z)}this.compile=function(N,W,ie=null){ie===null&&(ie=N),E!==null&&E.renderStart(N,W,ie),b=re.get(ie),b.init(W),w.push(b),ie.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),N!==ie&&N.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),b.setupLights(),E!==null&&E.updateLights(b.state.lightsArray),gn=this.localClippingEnabled,Yt=le.init(this.clippingPlanes,gn),Yt===!0&&le.setGlobalState(this.clippingPlanes,W),E!==null&&ve.render(b.state.shadowsArray,ie,W);let Z=new Set;return N.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Re=K.material;if(Re)if(Array.isArray(Re))for(let Ne=0;Ne<Re.length;Ne++){let Pe=Re[Ne];Na(Pe,ie,W,K),Z.add(Pe)}else Na(Re,ie,W,K),Z.add(Re)}),b=w.pop(),E!==null&&E.renderEnd(),Z},this.compileAsync=function(N,W,ie=null){let Z=this.compile(N,W,ie);return new Promise(K=>{function Re(){if(Z.forEach(function(Ne){let De=$e.get(Ne).currentProgram;(De===void 0||De.isReady())&&Z.delete(Ne)}),Z.size===0){K(N);return}setTimeout(Re,10)}Ze.get("KHR_parallel_shader_compile")!==null?Re():setTimeout(Re,10)})};let xo=null;function bf(N){xo&&xo(N)}function ic(){Ps.stop()}function cs(){Ps.start()}let Ps=new $_;Ps.setAnimationLoop(bf),typeof self<"u"&&Ps.setContext(self),this.setAnimationLoop=function(N){xo=N,ge.setAnimationLoop(N),N===null?Ps.stop():Ps.start()},ge.addEventListener("sessionstart",ic),ge.addEventListener("sessionend",cs),this.render=function(N,W){if(W!==void 0&&W.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;E!==null&&E.renderStart(N,W);let ie=ge.enabled===!0&&ge.isPresenting===!0,Z=R!==null&&(se===null||ie)&&R.begin(C,se);if(N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ge.enabled===!0&&ge.isPresenting===!0&&(R===null||R.isCompositing()===!1)&&(ge.cameraAutoUpdate===!0&&ge.updateCamera(W),W=ge.getCamera()),N.isScene===!0&&N.onBeforeRender(C,N,W,se),b=re.get(N,w.length),b.init(W),b.state.textureUnits=Ye.getTextureUnits(),w.push(b),Gt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?nn.setFromArrayCamera(W):ot.setFromProjectionMatrix(Gt,Vi,W.reversedDepth),gn=this.localClippingEnabled,Yt=le.init(this.clippingPlanes,gn),T=we.get(N,m.length),T.init(),m.push(T),this.info.render.frame++,ge.enabled===!0&&ge.isPresenting===!0){let Ne=C.xr.getDepthSensingMesh();Ne!==null&&Is(Ne,W,-1/0,C.sortObjects)}Is(N,W,0,C.sortObjects),T.finish(),E!==null&&E.updateLights(b.state.lightsArray),C.sortObjects===!0&&T.sort(Me,We),on=ge.enabled===!1||ge.isPresenting===!1||ge.hasDepthSensing()===!1,on&&V.addToRenderList(T,N),this.info.autoReset===!0&&this.info.reset(),Yt===!0&&le.beginShadows();let K=b.state.shadowsArray;if(ve.render(K,N,W),Yt===!0&&le.endShadows(),(Z&&R.hasRenderPass())===!1){let Ne=T.opaque,Pe=T.transmissive;if(b.setupLights(),W.isArrayCamera){let De=W.cameras;if(Pe.length>0)for(let He=0,st=De.length;He<st;He++){let gt=De[He];Xi(Ne,Pe,N,gt)}on&&V.render(N);for(let He=0,st=De.length;He<st;He++){let gt=De[He];Da(T,N,gt,gt.viewport)}}else Pe.length>0&&Xi(Ne,Pe,N,W),on&&V.render(N),Da(T,N,W)}se!==null&&k===0&&(Ye.updateMultisampleRenderTarget(se),Ye.updateRenderTargetMipmap(se)),Z&&R.end(C),N.isScene===!0&&N.onAfterRender(C,N,W),Ae.resetDefaultState(),q=-1,J=null,w.pop(),w.length>0?(b=w[w.length-1],Ye.setTextureUnits(b.state.textureUnits),Yt===!0&&le.setGlobalState(C.clippingPlanes,b.state.camera)):b=null,m.pop(),m.length>0?T=m[m.length-1]:T=null,E!==null&&E.renderEnd()};function Is(N,W,ie,Z){if(N.visible===!1)return;if(N.layers.test(W.layers)){if(N.isGroup)ie=N.renderOrder;else if(N.isLOD)N.autoUpdate===!0&&N.update(W);else if(N.isLight)b.pushLight(N),N.castShadow&&b.pushShadow(N);else if(N.isSprite){let Ne=W.isArrayCamera?nn:ot;if(!N.frustumCulled||N.intersectsFrustum(Ne)){Z&&Tt.setFromMatrixPosition(N.matrixWorld).applyMatrix4(Gt);let Pe=xe.update(N),De=N.material;De.visible&&T.push(N,Pe,De,ie,Tt.z,null,W)}}else if(N.isMesh||N.isLine||N.isPoints){let Ne=W.isArrayCamera?nn:ot;if(!N.frustumCulled||N.intersectsFrustum(Ne)){let Pe=xe.update(N),De=N.material;if(Z&&(N.boundingSphere!==void 0?(N.boundingSphere===null&&N.computeBoundingSphere(),Tt.copy(N.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),Tt.copy(Pe.boundingSphere.center)),Tt.applyMatrix4(N.matrixWorld).applyMatrix4(Gt)),Array.isArray(De)){let He=Pe.groups;for(let st=0,gt=He.length;st<gt;st++){let Ve=He[st],_t=De[Ve.materialIndex];_t&&_t.visible&&T.push(N,Pe,_t,ie,Tt.z,Ve,W)}}else De.visible&&T.push(N,Pe,De,ie,Tt.z,null,W)}}}let Re=N.children;for(let Ne=0,Pe=Re.length;Ne<Pe;Ne++)Is(Re[Ne],W,ie,Z)}function Da(N,W,ie,Z){let{opaque:K,transmissive:Re,transparent:Ne}=N;b.setupLightsView(ie),Yt===!0&&le.setGlobalState(C.clippingPlanes,ie),Z&&Ee.viewport(ne.copy(Z)),K.length>0&&an(K,W,ie),Re.length>0&&an(Re,W,ie),Ne.length>0&&an(Ne,W,ie),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Xi(N,W,ie,Z){if((ie.isScene===!0?ie.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[Z.id]===void 0){let Ve=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[Z.id]=new Ri(1,1,{generateMipmaps:!0,type:Ve?ns:gi,minFilter:Js,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Re=b.state.transmissionRenderTarget[Z.id],Ne=Z.viewport||ne;Re.setSize(Ne.z*C.transmissionResolutionScale,Ne.w*C.transmissionResolutionScale);let Pe=C.getRenderTarget(),De=C.getActiveCubeFace(),He=C.getActiveMipmapLevel();C.setRenderTarget(Re),C.getClearColor(j),he=C.getClearAlpha(),he<1&&C.setClearColor(16777215,.5),C.clear(),on&&V.render(ie);let st=C.toneMapping;C.toneMapping=Ss;let gt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),b.setupLightsView(Z),Yt===!0&&le.setGlobalState(C.clippingPlanes,Z),an(N,ie,Z),Ye.updateMultisampleRenderTarget(Re),Ye.updateRenderTargetMipmap(Re),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let _t=0,rn=W.length;_t<rn;_t++){let Ut=W[_t],{object:Bt,geometry:Cn,material:Be,group:xn}=Ut;if(Be.side===mi&&Bt.layers.test(Z.layers)){let yt=Be.side;Be.side=fi,Be.needsUpdate=!0,dn(Bt,ie,Z,Cn,Be,xn),Be.side=yt,Be.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ye.updateMultisampleRenderTarget(Re),Ye.updateRenderTargetMipmap(Re))}C.setRenderTarget(Pe,De,He),C.setClearColor(j,he),gt!==void 0&&(Z.viewport=gt),C.toneMapping=st}function an(N,W,ie){let Z=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Re=N.length;K<Re;K++){let Ne=N[K],{object:Pe,geometry:De,group:He}=Ne,st=Ne.material;st.allowOverride===!0&&Z!==null&&(st=Z),Pe.layers.test(ie.layers)&&dn(Pe,W,ie,De,st,He)}}function dn(N,W,ie,Z,K,Re){E!==null&&K.isNodeMaterial&&E.setObject(N,K),N.onBeforeRender(C,W,ie,Z,K,Re),N.modelViewMatrix.multiplyMatrices(ie.matrixWorldInverse,N.matrixWorld),N.normalMatrix.getNormalMatrix(N.modelViewMatrix),K.onBeforeRender(C,W,ie,Z,N,Re),K.transparent===!0&&K.side===mi&&K.forceSinglePass===!1?(K.side=fi,K.needsUpdate=!0,C.renderBufferDirect(ie,W,Z,K,N,Re),K.side=Ar,K.needsUpdate=!0,C.renderBufferDirect(ie,W,Z,K,N,Re),K.side=mi):C.renderBufferDirect(ie,W,Z,K,N,Re),N.onAfterRender(C,W,ie,Z,K,Re)}function pn(N){let W=0;for(let ie of N)ie.texture!==null&&W++;return W}function us(N,W,ie){W.isScene!==!0&&(W=En);let Z=$e.get(N),K=b.state.lights,Re=b.state.shadowsArray,Ne=K.state.version,Pe=fe.getParameters(N,K.state,Re,W,ie,b.state.lightProbeGridArray),De=fe.getProgramCacheKey(Pe),He=Z.programs;Z.environment=N.isMeshStandardMaterial||N.isMeshLambertMaterial||N.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let st=N.isMeshStandardMaterial||N.isMeshLambertMaterial&&!N.envMap||N.isMeshPhongMaterial&&!N.envMap;Z.envMap=O.get(N.envMap||Z.environment,st),Z.envMapRotation=Z.environment!==null&&N.envMap===null?W.environmentRotation:N.envMapRotation,He===void 0&&(N.addEventListener("dispose",ut),He=new Map,Z.programs=He,Z.programVariants=new Map);let gt=He.get(De);if(gt!==void 0){if(Z.currentProgram===gt&&Z.lightsStateVersion===Ne)return Fa(N,Pe),gt}else Pe.uniforms=fe.getUniforms(N),E!==null&&N.isNodeMaterial&&E.build(N,ie,Pe),N.onBeforeCompile(Pe,C),gt=fe.acquireProgram(Pe,De),He.set(De,gt),Z.uniforms=Pe.uniforms;let Ve=Z.uniforms;return(!N.isShaderMaterial&&!N.isRawShaderMaterial||N.clipping===!0)&&(Ve.clippingPlanes=le.uniform),Fa(N,Pe),Z.needsLights=or(N),Z.lightsStateVersion=Ne,Z.needsLights&&(Ve.ambientLightColor.value=K.state.ambient,Ve.lightProbe.value=K.state.probe,Ve.sunLights.value=K.state.sun,Ve.sunLightShadows.value=K.state.sunShadow,Ve.directionalLights.value=K.state.directional,Ve.directionalLightShadows.value=K.state.directionalShadow,Ve.spotLights.value=K.state.spot,Ve.spotLightShadows.value=K.state.spotShadow,Ve.rectAreaLights.value=K.state.rectArea,Ve.ltc_1.value=K.state.rectAreaLTC1,Ve.ltc_2.value=K.state.rectAreaLTC2,Ve.pointLights.value=K.state.point,Ve.pointLightShadows.value=K.state.pointShadow,Ve.hemisphereLights.value=K.state.hemi,Ve.sunShadowMatrix.value=K.state.sunShadowMatrix,Ve.sunShadowCascade.value=K.state.sunShadowCascade,Ve.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ve.spotLightMatrix.value=K.state.spotLightMatrix,Ve.spotLightMap.value=K.state.spotLightMap,Ve.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=pn(b.state.lightProbeGridArray),Z.currentProgram=gt,Z.uniformsList=null,gt}function xi(N,W,ie,Z,K){let Re=$e.get(N),Ne=Re.currentProgram.id+","+Z+","+K,Pe=Re.programVariants.get(Ne);return Pe===void 0?(Pe=us(N,W,ie),Re.programVariants.set(Ne,Pe)):(Re.currentProgram=Pe,Re.uniformsList=null,Re.outputColorSpace=Z,Re.toneMapping=K),Pe}function rr(N){if(N.uniformsList===null){let W=N.currentProgram.getUniforms();N.uniformsList=ha.seqWithValue(W.seq,N.uniforms)}return N.uniformsList}function Fa(N,W){let ie=$e.get(N);ie.outputColorSpace=W.outputColorSpace,ie.batching=W.batching,ie.batchingColor=W.batchingColor,ie.instancing=W.instancing,ie.instancingColor=W.instancingColor,ie.instancingMorph=W.instancingMorph,ie.skinning=W.skinning,ie.morphTargets=W.morphTargets,ie.morphNormals=W.morphNormals,ie.morphColors=W.morphColors,ie.morphTargetsCount=W.morphTargetsCount,ie.numClippingPlanes=W.numClippingPlanes,ie.numIntersection=W.numClipIntersection,ie.vertexAlphas=W.vertexAlphas,ie.vertexTangents=W.vertexTangents,ie.toneMapping=W.toneMapping}function Oa(N,W,ie,Z,K){W.isScene!==!0&&(W=En),Ye.resetTextureUnits();let Re=W.fog,Ne=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Pe=se===null?C.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:bt.workingColorSpace,De=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,He=O.get(Z.envMap||Ne,De),st=Z.vertexColors===!0&&!!ie.attributes.color&&ie.attributes.color.itemSize===4,gt=!!ie.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ve=!!ie.morphAttributes.position,_t=!!ie.morphAttributes.normal,rn=!!ie.morphAttributes.color,Ut=Ss;Z.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(Ut=C.toneMapping);let Bt=ie.morphAttributes.position||ie.morphAttributes.normal||ie.morphAttributes.color,Cn=Bt!==void 0?Bt.length:0,Be=$e.get(Z),xn=b.state.lights;if(Yt===!0&&(gn===!0||N!==J)){let kt=N===J&&Z.id===q;le.setState(Z,N,kt)}let yt=!1,Ls=!1;Z.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==xn.state.version||K.isBatchedMesh&&Be.batching===!1||!K.isBatchedMesh&&Be.batching===!0||K.isBatchedMesh&&Be.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Be.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Be.instancing===!1||!K.isInstancedMesh&&Be.instancing===!0||K.isSkinnedMesh&&Be.skinning===!1||!K.isSkinnedMesh&&Be.skinning===!0||K.isInstancedMesh&&Be.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Be.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Be.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Be.instancingMorph===!1&&K.morphTexture!==null||Be.envMap!==He||Z.fog===!0&&Be.fog!==Re||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==le.numPlanes||Be.numIntersection!==le.numIntersection)||Be.vertexAlphas!==st||Be.vertexTangents!==gt||Be.morphTargets!==Ve||Be.morphNormals!==_t||Be.morphColors!==rn||Be.morphTargetsCount!==Cn||Be.numLightProbeGrids!==pn(b.state.lightProbeGridArray)?yt=!0:(Be.outputColorSpace!==Pe||Be.toneMapping!==Ut)&&(Ls=!0):(yt=!0,Be.__version=Z.version);let yn=Be.currentProgram;(yt===!0||Ls===!0)&&(yn=Ls===!0?xi(Z,W,K,Pe,Ut):us(Z,W,K),E&&Z.isNodeMaterial&&E.onUpdateProgram(Z,yn,Be));let bo=!1,hs=!1,Ns=!1,ft=yn.getUniforms(),ln=Be.uniforms;if(Ee.useProgram(yn.program)&&(bo=!0,hs=!0,Ns=!0),Z.id!==q&&(q=Z.id,hs=!0),bo||J!==N){Ee.buffers.depth.getReversed()&&N.reversedDepth!==!0&&(N._reversedDepth=!0,N.updateProjectionMatrix()),ft.setValue(G,"projectionMatrix",N.projectionMatrix),ft.setValue(G,"viewMatrix",N.matrixWorldInverse);let vn=ft.map.cameraPosition;vn!==void 0&&vn.setValue(G,Fn.setFromMatrixPosition(N.matrixWorld)),lt.logarithmicDepthBuffer&&ft.setValue(G,"logDepthBufFC",2/(Math.log(N.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ft.setValue(G,"isOrthographic",N.isOrthographicCamera===!0),J!==N&&(J=N,hs=!0,Ns=!0)}if(Be.needsLights&&(xn.state.sunShadowMap.length>0&&ft.setValue(G,"sunShadowMap",xn.state.sunShadowMap,Ye),xn.state.directionalShadowMap.length>0&&ft.setValue(G,"directionalShadowMap",xn.state.directionalShadowMap,Ye),xn.state.spotShadowMap.length>0&&ft.setValue(G,"spotShadowMap",xn.state.spotShadowMap,Ye),xn.state.pointShadowMap.length>0&&ft.setValue(G,"pointShadowMap",xn.state.pointShadowMap,Ye)),K.isSkinnedMesh){ft.setOptional(G,K,"bindMatrix"),ft.setOptional(G,K,"bindMatrixInverse");let kt=K.skeleton;kt&&(kt.boneTexture===null&&kt.computeBoneTexture(),ft.setValue(G,"boneTexture",kt.boneTexture,Ye))}K.isBatchedMesh&&(ft.setOptional(G,K,"batchingTexture"),ft.setValue(G,"batchingTexture",K._matricesTexture,Ye),ft.setOptional(G,K,"batchingIdTexture"),ft.setValue(G,"batchingIdTexture",K._indirectTexture,Ye),ft.setOptional(G,K,"batchingColorTexture"),K._colorsTexture!==null&&ft.setValue(G,"batchingColorTexture",K._colorsTexture,Ye));let ai=ie.morphAttributes;if((ai.position!==void 0||ai.normal!==void 0||ai.color!==void 0)&&ce.update(K,ie,yn),(hs||Be.receiveShadow!==K.receiveShadow)&&(Be.receiveShadow=K.receiveShadow,ft.setValue(G,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(ln.envMapIntensity.value=W.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=rE()),hs){if(ft.setValue(G,"toneMappingExposure",C.toneMappingExposure),Be.needsLights&&yo(ln,Ns),Re&&Z.fog===!0&&Se.refreshFogUniforms(ln,Re),Se.refreshMaterialUniforms(ln,Z,ue,Q,b.state.transmissionRenderTarget[N.id]),Be.needsLights&&Be.numLightProbeGrids>0){let kt=S,vn=0;for(let Zn of b.state.lightProbeGridArray)Zn.texture!==null&&(kt.textures[vn]=Zn.texture,kt.min[vn]=Zn.boundingBox.min,kt.max[vn]=Zn.boundingBox.max,kt.resolution[vn]=Zn.resolution,vn++);for(let Zn in kt)kt[Zn].length=vn;ln.probesSH.value=kt.textures,ln.probesMin.value=kt.min,ln.probesMax.value=kt.max,ln.probesResolution.value=kt.resolution}ha.upload(G,rr(Be),ln,Ye)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(ha.upload(G,rr(Be),ln,Ye),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ft.setValue(G,"center",K.center),ft.setValue(G,"modelViewMatrix",K.modelViewMatrix),ft.setValue(G,"normalMatrix",K.normalMatrix),ft.setValue(G,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let kt=Z.uniformsGroups;for(let vn=0,Zn=kt.length;vn<Zn;vn++){let sc=kt[vn];Xe.update(sc,yn),Xe.bind(sc,yn)}}return yn}function yo(N,W){N.ambientLightColor.needsUpdate=W,N.lightProbe.needsUpdate=W,N.sunLights.needsUpdate=W,N.sunLightShadows.needsUpdate=W,N.directionalLights.needsUpdate=W,N.directionalLightShadows.needsUpdate=W,N.pointLights.needsUpdate=W,N.pointLightShadows.needsUpdate=W,N.spotLights.needsUpdate=W,N.spotLightShadows.needsUpdate=W,N.rectAreaLights.needsUpdate=W,N.hemisphereLights.needsUpdate=W}function or(N){return N.isMeshLambertMaterial||N.isMeshToonMaterial||N.isMeshPhongMaterial||N.isMeshStandardMaterial||N.isShadowMaterial||N.isShaderMaterial&&N.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(N,W,ie){let Z=$e.get(N);Z.__autoAllocateDepthBuffer=N.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),$e.get(N.texture).__webglTexture=W,$e.get(N.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:ie,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(N,W){let ie=$e.get(N);ie.__webglFramebuffer=W,ie.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(N,W=0,ie=0){se=N,X=W,k=ie;let Z=null,K=!1,Re=!1;if(N){let Pe=$e.get(N);if(Pe.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(G.FRAMEBUFFER,Pe.__webglFramebuffer),ne.copy(N.viewport),pe.copy(N.scissor),te=N.scissorTest,Ee.viewport(ne),Ee.scissor(pe),Ee.setScissorTest(te),q=-1;return}else if(Pe.__webglFramebuffer===void 0)Ye.setupRenderTarget(N);else if(Pe.__hasExternalTextures)Ye.rebindTextures(N,$e.get(N.texture).__webglTexture,$e.get(N.depthTexture).__webglTexture);else if(N.depthBuffer){let st=N.depthTexture;if(Pe.__boundDepthTexture!==st){if(st!==null&&$e.has(st)&&(N.width!==st.image.width||N.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(N)}}let De=N.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Re=!0);let He=$e.get(N).__webglFramebuffer;N.isWebGLCubeRenderTarget?(Array.isArray(He[W])?Z=He[W][ie]:Z=He[W],K=!0):N.samples>0&&Ye.useMultisampledRTT(N)===!1?Z=$e.get(N).__webglMultisampledFramebuffer:Array.isArray(He)?Z=He[ie]:Z=He,ne.copy(N.viewport),pe.copy(N.scissor),te=N.scissorTest}else ne.copy(Ge).multiplyScalar(ue).floor(),pe.copy(pt).multiplyScalar(ue).floor(),te=ht;if(ie!==0&&(Z=F),Ee.bindFramebuffer(G.FRAMEBUFFER,Z)&&Ee.drawBuffers(N,Z),Ee.viewport(ne),Ee.scissor(pe),Ee.setScissorTest(te),K){let Pe=$e.get(N.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,Pe.__webglTexture,ie)}else if(Re){let Pe=W;for(let De=0;De<N.textures.length;De++){let He=$e.get(N.textures[De]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+De,He.__webglTexture,ie,Pe)}}else if(N!==null&&ie!==0){let Pe=$e.get(N.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Pe.__webglTexture,ie)}q=-1};function vo(N){let W=$e.get(N);return(W.__readFormat!==N.format||W.__readType!==N.type)&&(W.__readFormat=N.format,W.__readType=N.type,W.__formatReadable=lt.textureFormatReadable(N.format),W.__typeReadable=lt.textureTypeReadable(N.type)),W}this.readRenderTargetPixels=function(N,W,ie,Z,K,Re,Ne,Pe=0){if(!(N&&N.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=$e.get(N).__webglFramebuffer;if(N.isWebGLCubeRenderTarget&&Ne!==void 0&&(De=De[Ne],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(G.FRAMEBUFFER,De);try{let He=N.textures[Pe],st=He.format,gt=He.type;N.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Pe);let Ve=vo(He);if(Ve.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=N.width-Z&&ie>=0&&ie<=N.height-K&&G.readPixels(W,ie,Z,K,be.convert(st),be.convert(gt),Re)}finally{let He=se!==null?$e.get(se).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(N,W,ie,Z,K,Re,Ne,Pe=0){if(!(N&&N.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=$e.get(N).__webglFramebuffer;if(N.isWebGLCubeRenderTarget&&Ne!==void 0&&(De=De[Ne],Array.isArray(De)&&(De=De[0])),De)if(W>=0&&W<=N.width-Z&&ie>=0&&ie<=N.height-K){Ee.bindFramebuffer(G.FRAMEBUFFER,De);let He=N.textures[Pe],st=He.format,gt=He.type;N.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Pe);let Ve=vo(He);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.bufferData(G.PIXEL_PACK_BUFFER,Re.byteLength,G.STREAM_READ),G.readPixels(W,ie,Z,K,be.convert(st),be.convert(gt),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let rn=se!==null?$e.get(se).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,rn);let Ut=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await g_(G,Ut,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Re),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(_t),G.deleteSync(Ut),Re}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(N,W=null,ie=0){let Z=Math.pow(2,-ie),K=Math.floor(N.image.width*Z),Re=Math.floor(N.image.height*Z),Ne=W!==null?W.x:0,Pe=W!==null?W.y:0;Ye.setTexture2D(N,0),G.copyTexSubImage2D(G.TEXTURE_2D,ie,0,0,Ne,Pe,K,Re),Ee.unbindTexture()},this.copyTextureToTexture=function(N,W,ie=null,Z=null,K=0,Re=0){let Ne,Pe,De,He,st,gt,Ve,_t,rn,Ut=N.isCompressedTexture?N.mipmaps[Re]:N.image;if(ie!==null)Ne=ie.max.x-ie.min.x,Pe=ie.max.y-ie.min.y,De=ie.isBox3?ie.max.z-ie.min.z:1,He=ie.min.x,st=ie.min.y,gt=ie.isBox3?ie.min.z:0;else{let ft=Math.pow(2,-K);Ne=Math.floor(Ut.width*ft),Pe=Math.floor(Ut.height*ft),N.isDataArrayTexture?De=Ut.depth:N.isData3DTexture?De=Math.floor(Ut.depth*ft):De=1,He=0,st=0,gt=0}Z!==null?(Ve=Z.x,_t=Z.y,rn=Z.z):(Ve=0,_t=0,rn=0);let Bt=be.convert(W.format),Cn=be.convert(W.type),Be;W.isData3DTexture?(Ye.setTexture3D(W,0),Be=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Ye.setTexture2DArray(W,0),Be=G.TEXTURE_2D_ARRAY):(Ye.setTexture2D(W,0),Be=G.TEXTURE_2D),Ee.activeTexture(G.TEXTURE0),Ee.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),Ee.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Ee.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let xn=Ee.getParameter(G.UNPACK_ROW_LENGTH),yt=Ee.getParameter(G.UNPACK_IMAGE_HEIGHT),Ls=Ee.getParameter(G.UNPACK_SKIP_PIXELS),yn=Ee.getParameter(G.UNPACK_SKIP_ROWS),bo=Ee.getParameter(G.UNPACK_SKIP_IMAGES);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,Ut.width),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ut.height),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,He),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,st),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,gt);let hs=N.isDataArrayTexture||N.isData3DTexture,Ns=W.isDataArrayTexture||W.isData3DTexture;if(N.isDepthTexture){let ft=$e.get(N),ln=$e.get(W),ai=$e.get(ft.__renderTarget),kt=$e.get(ln.__renderTarget);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,ai.__webglFramebuffer),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,kt.__webglFramebuffer);for(let vn=0;vn<De;vn++)hs&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,$e.get(N).__webglTexture,K,gt+vn),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,$e.get(W).__webglTexture,Re,rn+vn)),G.blitFramebuffer(He,st,He+Ne,st+Pe,Ve,_t,Ve+Ne,_t+Pe,G.DEPTH_BUFFER_BIT,G.NEAREST);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(K!==0||N.isRenderTargetTexture||$e.has(N)){let ft=$e.get(N),ln=$e.get(W);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,D),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,z);for(let ai=0;ai<De;ai++)hs?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ft.__webglTexture,K,gt+ai):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ft.__webglTexture,K),Ns?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ln.__webglTexture,Re,rn+ai):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ln.__webglTexture,Re),K!==0?G.blitFramebuffer(He,st,He+Ne,st+Pe,Ve,_t,Ve+Ne,_t+Pe,G.COLOR_BUFFER_BIT,G.NEAREST):Ns?G.copyTexSubImage3D(Be,Re,Ve,_t,rn+ai,He,st,Ne,Pe):G.copyTexSubImage2D(Be,Re,Ve,_t,He,st,Ne,Pe);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Ns?N.isDataTexture||N.isData3DTexture?G.texSubImage3D(Be,Re,Ve,_t,rn,Ne,Pe,De,Bt,Cn,Ut.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(Be,Re,Ve,_t,rn,Ne,Pe,De,Bt,Ut.data):G.texSubImage3D(Be,Re,Ve,_t,rn,Ne,Pe,De,Bt,Cn,Ut):N.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Re,Ve,_t,Ne,Pe,Bt,Cn,Ut.data):N.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Re,Ve,_t,Ut.width,Ut.height,Bt,Ut.data):G.texSubImage2D(G.TEXTURE_2D,Re,Ve,_t,Ne,Pe,Bt,Cn,Ut);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,xn),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,yt),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,Ls),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,yn),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,bo),Re===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&G.generateMipmap(Be),Ee.unbindTexture()},this.initRenderTarget=function(N){$e.get(N).__webglFramebuffer===void 0&&Ye.setupRenderTarget(N)},this.initTexture=function(N){N.isCubeTexture?Ye.setTextureCube(N,0):N.isData3DTexture?Ye.setTexture3D(N,0):N.isDataArrayTexture||N.isCompressedArrayTexture?Ye.setTexture2DArray(N,0):Ye.setTexture2D(N,0),Ee.unbindTexture()},this.resetState=function(){X=0,k=0,se=null,Ee.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var ss=new rt,Sh=class extends jr{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,i,s){let r=this,o=new bl(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},i,s)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(M,S=0){let T=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,b="",m=T.exec(M);m!==null&&(b=m[1]);let w={comments:[],elements:[],headerLength:S,objInfo:""},R=b.split(/\r\n|\r|\n/),C;function I(E,F){let D={type:E[0]};return D.type==="list"?(D.name=E[3],D.countType=E[1],D.itemType=E[2]):D.name=E[1],D.name in F&&(D.name=F[D.name]),D}for(let E=0;E<R.length;E++){let F=R[E];if(F=F.trim(),F==="")continue;let D=F.split(/\s+/),z=D.shift();switch(F=D.join(" "),z){case"format":w.format=D[0],w.version=D[1];break;case"comment":w.comments.push(F);break;case"element":C!==void 0&&w.elements.push(C),C={},C.name=D[0],C.count=parseInt(D[1]),C.properties=[];break;case"property":C.properties.push(I(D,_.propertyNameMapping));break;case"obj_info":w.objInfo=F;break;default:console.log("unhandled",z,D)}}return C!==void 0&&w.elements.push(C),w}function i(M,S){switch(S){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(M);case"float":case"double":case"float32":case"float64":return parseFloat(M)}}function s(M,S){let T={};for(let b=0;b<M.length;b++){if(S.empty())return null;if(M[b].type==="list"){let m=[],w=i(S.next(),M[b].countType);for(let R=0;R<w;R++){if(S.empty())return null;m.push(i(S.next(),M[b].itemType))}T[M[b].name]=m}else T[M[b].name]=i(S.next(),M[b].type)}return T}function r(){let M={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let S of Object.keys(_.customPropertyMapping))M[S]=[];return M}function o(M){switch(M){case"int8":case"char":return cl;case"uint8":case"uchar":return ul;case"int16":case"short":return hl;case"uint16":case"ushort":return Xr;case"int32":case"int":return fl;case"uint32":case"uint":return qr;case"float32":case"float":return Pn;case"float64":case"double":return dp}}function a(M){switch(M){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(M){return M==="float"||M==="float32"||M==="double"||M==="float64"}function c(M){function S(se){for(let q of se){let J=M.find(ne=>ne.name===q);if(J)return J}return null}let T=S(["x","px","posx"]),b=S(["y","py","posy"]),m=S(["z","pz","posz"]),w=S(["nx","normalx"]),R=S(["ny","normaly"]),C=S(["nz","normalz"]),I=S(["s","u","texture_u","tx"]),E=S(["t","v","texture_v","ty"]),F=S(["red","diffuse_red","r","diffuse_r"]),D=S(["green","diffuse_green","g","diffuse_g"]),z=S(["blue","diffuse_blue","b","diffuse_b"]),X=S(["texcoord"]),k={};for(let se of Object.keys(_.customPropertyMapping)){let J=_.customPropertyMapping[se].map(te=>M.find(j=>j.name===te)),ne=J.filter(te=>te).map(te=>te.type),pe=ne.length>0&&ne.every(te=>te===ne[0]);k[se]={type:pe?ne[0]:"float32",usage:J.every(te=>te!==void 0)}}return{position:{names:[T?T.name:"x",b?b.name:"y",m?m.name:"z"],type:T?T.type:"float32",usage:!!(T&&b&&m)},normal:{names:[w?w.name:"nx",R?R.name:"ny",C?C.name:"nz"],type:w?w.type:"float32",usage:!!(w&&R&&C)},uv:{names:[I?I.name:"s",E?E.name:"t"],type:I?I.type:"float32",usage:!!(I&&E)},texcoord:{type:X?X.itemType:"float32",usage:!!X},color:{names:[F?F.name:"red",D?D.name:"green",z?z.name:"blue"],type:F?F.type:"uchar",usage:!!(F&&D&&z)},custom:k}}function u(M,S){let T=r(),b=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,m,w;(w=b.exec(M))!==null?m=w[1].split(/\s+/):m=[];let R=new pp(m);e:for(let C=0;C<S.elements.length;C++){let I=S.elements[C],E=c(I.properties);T.descriptors[I.name]=E;for(let F=0;F<I.count;F++){let D=s(I.properties,R);if(!D)break e;f(T,I.name,D,E)}}return h(T)}function h(M){let S=new jn,T=M.descriptors.vertex;M.indices.length>0&&S.setIndex(M.indices);let b=o(T?T.position.type:"float32");if(S.setAttribute("position",new b(M.vertices,3)),M.normals.length>0){let m=o(T.normal.type);S.setAttribute("normal",new m(M.normals,3))}if(M.uvs.length>0){let m=o(T.uv.type);S.setAttribute("uv",new m(M.uvs,2))}if(M.colors.length>0){let m=T.color.type,w=!l(m),R=o(m);S.setAttribute("color",new R(M.colors,3,w))}for(let m of Object.keys(_.customPropertyMapping))if(M[m].length>0){let w=o(T.custom[m].type);S.setAttribute(m,new w(M[m],_.customPropertyMapping[m].length))}if(M.faceVertexUvs.length>0||M.faceVertexColors.length>0){if(S=S.toNonIndexed(),M.faceVertexUvs.length>0){let m=o(M.descriptors.face.texcoord.type);S.setAttribute("uv",new m(M.faceVertexUvs,2))}if(M.faceVertexColors.length>0){let m=M.descriptors.face.color.type,w=!l(m),R=o(m);S.setAttribute("color",new R(M.faceVertexColors,3,w))}}return S.computeBoundingSphere(),S}function f(M,S,T,b){if(S==="vertex"){let{position:m,normal:w,uv:R,color:C}=b;if(m.usage&&M.vertices.push(T[m.names[0]],T[m.names[1]],T[m.names[2]]),w.usage&&M.normals.push(T[w.names[0]],T[w.names[1]],T[w.names[2]]),R.usage&&M.uvs.push(T[R.names[0]],T[R.names[1]]),C.usage){let I=a(C.type),E=l(C.type);ss.setRGB(T[C.names[0]]*I,T[C.names[1]]*I,T[C.names[2]]*I,ni);let F=1/I;M.colors.push(E?ss.r:Math.round(ss.r*F),E?ss.g:Math.round(ss.g*F),E?ss.b:Math.round(ss.b*F))}for(let I of Object.keys(_.customPropertyMapping))for(let E of _.customPropertyMapping[I])M[I].push(T[E])}else if(S==="face"){let m=T.vertex_indices||T.vertex_index,w=T.texcoord;m.length===3?(M.indices.push(m[0],m[1],m[2]),w&&w.length===6&&(M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[2],w[3]),M.faceVertexUvs.push(w[4],w[5]))):m.length===4&&(M.indices.push(m[0],m[1],m[2]),M.indices.push(m[0],m[2],m[3]),w&&w.length===8&&(M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[2],w[3]),M.faceVertexUvs.push(w[4],w[5]),M.faceVertexUvs.push(w[0],w[1]),M.faceVertexUvs.push(w[4],w[5]),M.faceVertexUvs.push(w[6],w[7])));let{color:R}=b;if(R.usage){let C=a(R.type);ss.setRGB(T[R.names[0]]*C,T[R.names[1]]*C,T[R.names[2]]*C,ni);let I=1/C,E=ss.r*I,F=ss.g*I,D=ss.b*I;M.faceVertexColors.push(E,F,D),M.faceVertexColors.push(E,F,D),M.faceVertexColors.push(E,F,D),m.length===4&&(M.faceVertexColors.push(E,F,D),M.faceVertexColors.push(E,F,D),M.faceVertexColors.push(E,F,D))}}}function d(M,S){let T={},b=0;for(let m=0;m<S.length;m++){let w=S[m],R=w.valueReader;if(w.type==="list"){let C=[],I=w.countReader.read(M+b);b+=w.countReader.size;for(let E=0;E<I;E++)C.push(R.read(M+b)),b+=R.size;T[w.name]=C}else T[w.name]=R.read(M+b),b+=R.size}return[T,b]}function y(M,S,T){function b(m,w,R){switch(w){case"int8":case"char":return{read:C=>m.getInt8(C),size:1};case"uint8":case"uchar":return{read:C=>m.getUint8(C),size:1};case"int16":case"short":return{read:C=>m.getInt16(C,R),size:2};case"uint16":case"ushort":return{read:C=>m.getUint16(C,R),size:2};case"int32":case"int":return{read:C=>m.getInt32(C,R),size:4};case"uint32":case"uint":return{read:C=>m.getUint32(C,R),size:4};case"float32":case"float":return{read:C=>m.getFloat32(C,R),size:4};case"float64":case"double":return{read:C=>m.getFloat64(C,R),size:8}}}for(let m=0,w=M.length;m<w;m++){let R=M[m];R.type==="list"?(R.countReader=b(S,R.countType,T),R.valueReader=b(S,R.itemType,T)):R.valueReader=b(S,R.type,T)}}function v(M,S){let T=r(),b=S.format==="binary_little_endian",m=new DataView(M,S.headerLength),w,R=0;for(let C=0;C<S.elements.length;C++){let I=S.elements[C],E=I.properties,F=c(E);T.descriptors[I.name]=F,y(E,m,b);for(let D=0;D<I.count;D++){w=d(R,E),R+=w[1];let z=w[0];f(T,I.name,z,F)}}return h(T)}function g(M){let S=0,T=!0,b="",m=[],w=new TextDecoder().decode(M.subarray(0,5)),R=/^ply\r\n/.test(w);do{let C=String.fromCharCode(M[S++]);C!==`
`&&C!=="\r"?b+=C:(b==="end_header"&&(T=!1),b!==""&&(m.push(b),b=""))}while(T&&S<M.length);return R===!0&&S++,{headerText:m.join("\r")+"\r",headerLength:S}}let x,_=this;if(e instanceof ArrayBuffer){let M=new Uint8Array(e),{headerText:S,headerLength:T}=g(M),b=t(S,T);if(b.format==="ascii"){let m=new TextDecoder().decode(M);x=u(m,b)}else x=v(e,b)}else x=u(e,t(e));return x}},dp=class extends Ft{constructor(e,t,i){super(new Float64Array(e),t,i)}},pp=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function no(n){for(var e=n.length/6|0,t=new Array(e),i=0;i<e;)t[i]="#"+n.slice(i*6,++i*6);return t}function ga(n,e,t){n.prototype=e.prototype=t,t.constructor=n}function Vl(n,e){var t=Object.create(n.prototype);for(var i in e)t[i]=e[i];return t}function Cr(){}var oo=.7,ma=1/oo,da="\\s*([+-]?\\d+)\\s*",kl="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",As="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",oE=/^#([0-9a-f]{3,8})$/,aE=new RegExp(`^rgb\\(${da},${da},${da}\\)$`),lE=new RegExp(`^rgb\\(${As},${As},${As}\\)$`),cE=new RegExp(`^rgba\\(${da},${da},${da},${kl}\\)$`),uE=new RegExp(`^rgba\\(${As},${As},${As},${kl}\\)$`),hE=new RegExp(`^hsl\\(${kl},${As},${As}\\)$`),fE=new RegExp(`^hsla\\(${kl},${As},${As},${kl}\\)$`),nx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};ga(Cr,Eh,{copy(n){return Object.assign(new this.constructor,this,n)},displayable(){return this.rgb().displayable()},hex:ix,formatHex:ix,formatHex8:dE,formatHsl:pE,formatRgb:sx,toString:sx});function ix(){return this.rgb().formatHex()}function dE(){return this.rgb().formatHex8()}function pE(){return dx(this).formatHsl()}function sx(){return this.rgb().formatRgb()}function Eh(n){var e,t;return n=(n+"").trim().toLowerCase(),(e=oE.exec(n))?(t=e[1].length,e=parseInt(e[1],16),t===6?rx(e):t===3?new Wn(e>>8&15|e>>4&240,e>>4&15|e&240,(e&15)<<4|e&15,1):t===8?Mh(e>>24&255,e>>16&255,e>>8&255,(e&255)/255):t===4?Mh(e>>12&15|e>>8&240,e>>8&15|e>>4&240,e>>4&15|e&240,((e&15)<<4|e&15)/255):null):(e=aE.exec(n))?new Wn(e[1],e[2],e[3],1):(e=lE.exec(n))?new Wn(e[1]*255/100,e[2]*255/100,e[3]*255/100,1):(e=cE.exec(n))?Mh(e[1],e[2],e[3],e[4]):(e=uE.exec(n))?Mh(e[1]*255/100,e[2]*255/100,e[3]*255/100,e[4]):(e=hE.exec(n))?lx(e[1],e[2]/100,e[3]/100,1):(e=fE.exec(n))?lx(e[1],e[2]/100,e[3]/100,e[4]):nx.hasOwnProperty(n)?rx(nx[n]):n==="transparent"?new Wn(NaN,NaN,NaN,0):null}function rx(n){return new Wn(n>>16&255,n>>8&255,n&255,1)}function Mh(n,e,t,i){return i<=0&&(n=e=t=NaN),new Wn(n,e,t,i)}function vp(n){return n instanceof Cr||(n=Eh(n)),n?(n=n.rgb(),new Wn(n.r,n.g,n.b,n.opacity)):new Wn}function Gl(n,e,t,i){return arguments.length===1?vp(n):new Wn(n,e,t,i??1)}function Wn(n,e,t,i){this.r=+n,this.g=+e,this.b=+t,this.opacity=+i}ga(Wn,Gl,Vl(Cr,{brighter(n){return n=n==null?ma:Math.pow(ma,n),new Wn(this.r*n,this.g*n,this.b*n,this.opacity)},darker(n){return n=n==null?oo:Math.pow(oo,n),new Wn(this.r*n,this.g*n,this.b*n,this.opacity)},rgb(){return this},clamp(){return new Wn(so(this.r),so(this.g),so(this.b),Th(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.b<255.5&&0<=this.opacity&&this.opacity<=1},hex:ox,formatHex:ox,formatHex8:mE,formatRgb:ax,toString:ax}));function ox(){return`#${io(this.r)}${io(this.g)}${io(this.b)}`}function mE(){return`#${io(this.r)}${io(this.g)}${io(this.b)}${io((isNaN(this.opacity)?1:this.opacity)*255)}`}function ax(){let n=Th(this.opacity);return`${n===1?"rgb(":"rgba("}${so(this.r)}, ${so(this.g)}, ${so(this.b)}${n===1?")":`, ${n})`}`}function Th(n){return isNaN(n)?1:Math.max(0,Math.min(1,n))}function so(n){return Math.max(0,Math.min(255,Math.round(n)||0))}function io(n){return n=so(n),(n<16?"0":"")+n.toString(16)}function lx(n,e,t,i){return i<=0?n=e=t=NaN:t<=0||t>=1?n=e=NaN:e<=0&&(n=NaN),new rs(n,e,t,i)}function dx(n){if(n instanceof rs)return new rs(n.h,n.s,n.l,n.opacity);if(n instanceof Cr||(n=Eh(n)),!n)return new rs;if(n instanceof rs)return n;n=n.rgb();var e=n.r/255,t=n.g/255,i=n.b/255,s=Math.min(e,t,i),r=Math.max(e,t,i),o=NaN,a=r-s,l=(r+s)/2;return a?(e===r?o=(t-i)/a+(t<i)*6:t===r?o=(i-e)/a+2:o=(e-t)/a+4,a/=l<.5?r+s:2-r-s,o*=60):a=l>0&&l<1?0:o,new rs(o,a,l,n.opacity)}function Ch(n,e,t,i){return arguments.length===1?dx(n):new rs(n,e,t,i??1)}function rs(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}ga(rs,Ch,Vl(Cr,{brighter(n){return n=n==null?ma:Math.pow(ma,n),new rs(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?oo:Math.pow(oo,n),new rs(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=this.h%360+(this.h<0)*360,e=isNaN(n)||isNaN(this.s)?0:this.s,t=this.l,i=t+(t<.5?t:1-t)*e,s=2*t-i;return new Wn(mp(n>=240?n-240:n+120,s,i),mp(n,s,i),mp(n<120?n+240:n-120,s,i),this.opacity)},clamp(){return new rs(cx(this.h),wh(this.s),wh(this.l),Th(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&this.opacity<=1},formatHsl(){let n=Th(this.opacity);return`${n===1?"hsl(":"hsla("}${cx(this.h)}, ${wh(this.s)*100}%, ${wh(this.l)*100}%${n===1?")":`, ${n})`}`}}));function cx(n){return n=(n||0)%360,n<0?n+360:n}function wh(n){return Math.max(0,Math.min(1,n||0))}function mp(n,e,t){return(n<60?e+(t-e)*n/60:n<180?t:n<240?e+(t-e)*(240-n)/60:e)*255}var px=Math.PI/180,mx=180/Math.PI,Ah=18,gx=.96422,_x=1,xx=.82521,yx=4/29,pa=6/29,vx=3*pa*pa,gE=pa*pa*pa;function bx(n){if(n instanceof Es)return new Es(n.l,n.a,n.b,n.opacity);if(n instanceof Qs)return Mx(n);n instanceof Wn||(n=vp(n));var e=yp(n.r),t=yp(n.g),i=yp(n.b),s=gp((.2225045*e+.7168786*t+.0606169*i)/_x),r,o;return e===t&&t===i?r=o=s:(r=gp((.4360747*e+.3850649*t+.1430804*i)/gx),o=gp((.0139322*e+.0971045*t+.7141733*i)/xx)),new Es(116*s-16,500*(r-s),200*(s-o),n.opacity)}function Sx(n,e,t,i){return arguments.length===1?bx(n):new Es(n,e,t,i??1)}function Es(n,e,t,i){this.l=+n,this.a=+e,this.b=+t,this.opacity=+i}ga(Es,Sx,Vl(Cr,{brighter(n){return new Es(this.l+Ah*(n??1),this.a,this.b,this.opacity)},darker(n){return new Es(this.l-Ah*(n??1),this.a,this.b,this.opacity)},rgb(){var n=(this.l+16)/116,e=isNaN(this.a)?n:n+this.a/500,t=isNaN(this.b)?n:n-this.b/200;return e=gx*_p(e),n=_x*_p(n),t=xx*_p(t),new Wn(xp(3.1338561*e-1.6168667*n-.4906146*t),xp(-.9787684*e+1.9161415*n+.033454*t),xp(.0719453*e-.2289914*n+1.4052427*t),this.opacity)}}));function gp(n){return n>gE?Math.pow(n,1/3):n/vx+yx}function _p(n){return n>pa?n*n*n:vx*(n-yx)}function xp(n){return 255*(n<=.0031308?12.92*n:1.055*Math.pow(n,1/2.4)-.055)}function yp(n){return(n/=255)<=.04045?n/12.92:Math.pow((n+.055)/1.055,2.4)}function _E(n){if(n instanceof Qs)return new Qs(n.h,n.c,n.l,n.opacity);if(n instanceof Es||(n=bx(n)),n.a===0&&n.b===0)return new Qs(NaN,0<n.l&&n.l<100?0:NaN,n.l,n.opacity);var e=Math.atan2(n.b,n.a)*mx;return new Qs(e<0?e+360:e,Math.sqrt(n.a*n.a+n.b*n.b),n.l,n.opacity)}function Rh(n,e,t,i){return arguments.length===1?_E(n):new Qs(n,e,t,i??1)}function Qs(n,e,t,i){this.h=+n,this.c=+e,this.l=+t,this.opacity=+i}function Mx(n){if(isNaN(n.h))return new Es(n.l,0,0,n.opacity);var e=n.h*px;return new Es(n.l,Math.cos(e)*n.c,Math.sin(e)*n.c,n.opacity)}ga(Qs,Rh,Vl(Cr,{brighter(n){return new Qs(this.h,this.c,this.l+Ah*(n??1),this.opacity)},darker(n){return new Qs(this.h,this.c,this.l-Ah*(n??1),this.opacity)},rgb(){return Mx(this).rgb()}}));var wx=-.14861,bp=1.78277,Sp=-.29227,Ph=-.90649,zl=1.97294,ux=zl*Ph,hx=zl*bp,fx=bp*Sp-Ph*wx;function xE(n){if(n instanceof ro)return new ro(n.h,n.s,n.l,n.opacity);n instanceof Wn||(n=vp(n));var e=n.r/255,t=n.g/255,i=n.b/255,s=(fx*i+ux*e-hx*t)/(fx+ux-hx),r=i-s,o=(zl*(t-s)-Sp*r)/Ph,a=Math.sqrt(o*o+r*r)/(zl*s*(1-s)),l=a?Math.atan2(o,r)*mx-120:NaN;return new ro(l<0?l+360:l,a,s,n.opacity)}function Ih(n,e,t,i){return arguments.length===1?xE(n):new ro(n,e,t,i??1)}function ro(n,e,t,i){this.h=+n,this.s=+e,this.l=+t,this.opacity=+i}ga(ro,Ih,Vl(Cr,{brighter(n){return n=n==null?ma:Math.pow(ma,n),new ro(this.h,this.s,this.l*n,this.opacity)},darker(n){return n=n==null?oo:Math.pow(oo,n),new ro(this.h,this.s,this.l*n,this.opacity)},rgb(){var n=isNaN(this.h)?0:(this.h+120)*px,e=+this.l,t=isNaN(this.s)?0:this.s*e*(1-e),i=Math.cos(n),s=Math.sin(n);return new Wn(255*(e+t*(wx*i+bp*s)),255*(e+t*(Sp*i+Ph*s)),255*(e+t*(zl*i)),this.opacity)}}));function Ex(n,e,t,i,s){var r=n*n,o=r*n;return((1-3*n+3*r-o)*e+(4-6*r+3*o)*t+(1+3*n+3*r-3*o)*i+o*s)/6}function yE(n){var e=n.length-1;return function(t){var i=t<=0?t=0:t>=1?(t=1,e-1):Math.floor(t*e),s=n[i],r=n[i+1],o=i>0?n[i-1]:2*s-r,a=i<e-1?n[i+2]:2*r-s;return Ex((t-i/e)*e,o,s,r,a)}}function vE(n){var e=n.length;return function(t){var i=Math.floor(((t%=1)<0?++t:t)*e),s=n[(i+e-1)%e],r=n[i%e],o=n[(i+1)%e],a=n[(i+2)%e];return Ex((t-i/e)*e,s,r,o,a)}}var wp=n=>()=>n;function Cx(n,e){return function(t){return n+t*e}}function bE(n,e,t){return n=Math.pow(n,t),e=Math.pow(e,t)-n,t=1/t,function(i){return Math.pow(n+i*e,t)}}function Tp(n,e){var t=e-n;return t?Cx(n,t>180||t<-180?t-360*Math.round(t/360):t):wp(isNaN(n)?e:n)}function SE(n){return(n=+n)==1?_i:function(e,t){return t-e?bE(e,t,n):wp(isNaN(e)?t:e)}}function _i(n,e){var t=e-n;return t?Cx(n,t):wp(isNaN(n)?e:n)}var xN=(function n(e){var t=SE(e);function i(s,r){var o=t((s=Gl(s)).r,(r=Gl(r)).r),a=t(s.g,r.g),l=t(s.b,r.b),c=_i(s.opacity,r.opacity);return function(u){return s.r=o(u),s.g=a(u),s.b=l(u),s.opacity=c(u),s+""}}return i.gamma=n,i})(1);function Rx(n){return function(e){var t=e.length,i=new Array(t),s=new Array(t),r=new Array(t),o,a;for(o=0;o<t;++o)a=Gl(e[o]),i[o]=a.r||0,s[o]=a.g||0,r[o]=a.b||0;return i=n(i),s=n(s),r=n(r),a.opacity=1,function(l){return a.r=i(l),a.g=s(l),a.b=r(l),a+""}}}var Px=Rx(yE),yN=Rx(vE);function _a(n,e){return n=+n,e=+e,function(t){return n*(1-t)+e*t}}var ME=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,vN=new RegExp(ME.source,"g");var Tx=180/Math.PI,Mp={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function Ix(n,e,t,i,s,r){var o,a,l;return(o=Math.sqrt(n*n+e*e))&&(n/=o,e/=o),(l=n*t+e*i)&&(t-=n*l,i-=e*l),(a=Math.sqrt(t*t+i*i))&&(t/=a,i/=a,l/=a),n*i<e*t&&(n=-n,e=-e,l=-l,o=-o),{translateX:s,translateY:r,rotate:Math.atan2(e,n)*Tx,skewX:Math.atan(l)*Tx,scaleX:o,scaleY:a}}var Lh;function wE(n){let e=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(n+"");return e.isIdentity?Mp:Ix(e.a,e.b,e.c,e.d,e.e,e.f)}function TE(n){return n==null||(Lh||(Lh=document.createElementNS("http://www.w3.org/2000/svg","g")),Lh.setAttribute("transform",n),!(n=Lh.transform.baseVal.consolidate()))?Mp:(n=n.matrix,Ix(n.a,n.b,n.c,n.d,n.e,n.f))}function Lx(n,e,t,i){function s(c){return c.length?c.pop()+" ":""}function r(c,u,h,f,d,y){if(c!==h||u!==f){var v=d.push("translate(",null,e,null,t);y.push({i:v-4,x:_a(c,h)},{i:v-2,x:_a(u,f)})}else(h||f)&&d.push("translate("+h+e+f+t)}function o(c,u,h,f){c!==u?(c-u>180?u+=360:u-c>180&&(c+=360),f.push({i:h.push(s(h)+"rotate(",null,i)-2,x:_a(c,u)})):u&&h.push(s(h)+"rotate("+u+i)}function a(c,u,h,f){c!==u?f.push({i:h.push(s(h)+"skewX(",null,i)-2,x:_a(c,u)}):u&&h.push(s(h)+"skewX("+u+i)}function l(c,u,h,f,d,y){if(c!==h||u!==f){var v=d.push(s(d)+"scale(",null,",",null,")");y.push({i:v-4,x:_a(c,h)},{i:v-2,x:_a(u,f)})}else(h!==1||f!==1)&&d.push(s(d)+"scale("+h+","+f+")")}return function(c,u){var h=[],f=[];return c=n(c),u=n(u),r(c.translateX,c.translateY,u.translateX,u.translateY,h,f),o(c.rotate,u.rotate,h,f),a(c.skewX,u.skewX,h,f),l(c.scaleX,c.scaleY,u.scaleX,u.scaleY,h,f),c=u=null,function(d){for(var y=-1,v=f.length,g;++y<v;)h[(g=f[y]).i]=g.x(d);return h.join("")}}}var bN=Lx(wE,"px, ","px)","deg)"),SN=Lx(TE,", ",")",")"),AE=1e-12;function Ax(n){return((n=Math.exp(n))+1/n)/2}function EE(n){return((n=Math.exp(n))-1/n)/2}function CE(n){return((n=Math.exp(2*n))-1)/(n+1)}var MN=(function n(e,t,i){function s(r,o){var a=r[0],l=r[1],c=r[2],u=o[0],h=o[1],f=o[2],d=u-a,y=h-l,v=d*d+y*y,g,x;if(v<AE)x=Math.log(f/c)/e,g=function(m){return[a+m*d,l+m*y,c*Math.exp(e*m*x)]};else{var _=Math.sqrt(v),M=(f*f-c*c+i*v)/(2*c*t*_),S=(f*f-c*c-i*v)/(2*f*t*_),T=Math.log(Math.sqrt(M*M+1)-M),b=Math.log(Math.sqrt(S*S+1)-S);x=(b-T)/e,g=function(m){var w=m*x,R=Ax(T),C=c/(t*_)*(R*CE(e*w+T)-EE(T));return[a+C*d,l+C*y,c*R/Ax(e*w+T)]}}return g.duration=Math.abs(x)*1e3*e/Math.SQRT2,g}return s.rho=function(r){var o=Math.max(.001,+r),a=o*o,l=a*a;return n(o,a,l)},s})(Math.SQRT2,2,4);function Nx(n){return function(e,t){var i=n((e=Ch(e)).h,(t=Ch(t)).h),s=_i(e.s,t.s),r=_i(e.l,t.l),o=_i(e.opacity,t.opacity);return function(a){return e.h=i(a),e.s=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var wN=Nx(Tp),TN=Nx(_i);function Dx(n){return function(e,t){var i=n((e=Rh(e)).h,(t=Rh(t)).h),s=_i(e.c,t.c),r=_i(e.l,t.l),o=_i(e.opacity,t.opacity);return function(a){return e.h=i(a),e.c=s(a),e.l=r(a),e.opacity=o(a),e+""}}}var AN=Dx(Tp),EN=Dx(_i);function Fx(n){return(function e(t){t=+t;function i(s,r){var o=n((s=Ih(s)).h,(r=Ih(r)).h),a=_i(s.s,r.s),l=_i(s.l,r.l),c=_i(s.opacity,r.opacity);return function(u){return s.h=o(u),s.s=a(u),s.l=l(Math.pow(u,t)),s.opacity=c(u),s+""}}return i.gamma=e,i})(1)}var CN=Fx(Tp),RN=Fx(_i);var Ox=n=>Px(n[n.length-1]);var Ux=new Array(3).concat("ef8a62f7f7f767a9cf","ca0020f4a58292c5de0571b0","ca0020f4a582f7f7f792c5de0571b0","b2182bef8a62fddbc7d1e5f067a9cf2166ac","b2182bef8a62fddbc7f7f7f7d1e5f067a9cf2166ac","b2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac","b2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac","67001fb2182bd6604df4a582fddbc7d1e5f092c5de4393c32166ac053061","67001fb2182bd6604df4a582fddbc7f7f7f7d1e5f092c5de4393c32166ac053061").map(no),Ap=Ox(Ux);function Ep(n){return n=Math.max(0,Math.min(1,n)),"rgb("+Math.max(0,Math.min(255,Math.round(-4.54-n*(35.34-n*(2381.73-n*(6402.7-n*(7024.72-n*2710.57)))))))+", "+Math.max(0,Math.min(255,Math.round(32.49+n*(170.73+n*(52.82-n*(131.46-n*(176.58-n*67.37)))))))+", "+Math.max(0,Math.min(255,Math.round(81.24+n*(442.36-n*(2482.43-n*(6167.24-n*(6614.94-n*2475.67)))))))+")"}function Nh(n){var e=n.length;return function(t){return n[Math.max(0,Math.min(e-1,Math.floor(t*e)))]}}var Cp=Nh(no("44015444025645045745055946075a46085c460a5d460b5e470d60470e6147106347116447136548146748166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d54989d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723fde725")),RE=Nh(no("00000401000501010601010802010902020b02020d03030f03031204041405041606051806051a07061c08071e0907200a08220b09240c09260d0a290e0b2b100b2d110c2f120d31130d34140e36150e38160f3b180f3d19103f1a10421c10441d11471e114920114b21114e22115024125325125527125829115a2a115c2c115f2d11612f116331116533106734106936106b38106c390f6e3b0f703d0f713f0f72400f74420f75440f764510774710784910784a10794c117a4e117b4f127b51127c52137c54137d56147d57157e59157e5a167e5c167f5d177f5f187f601880621980641a80651a80671b80681c816a1c816b1d816d1d816e1e81701f81721f817320817521817621817822817922827b23827c23827e24828025828125818326818426818627818827818928818b29818c29818e2a81902a81912b81932b80942c80962c80982d80992d809b2e7f9c2e7f9e2f7fa02f7fa1307ea3307ea5317ea6317da8327daa337dab337cad347cae347bb0357bb2357bb3367ab5367ab73779b83779ba3878bc3978bd3977bf3a77c03a76c23b75c43c75c53c74c73d73c83e73ca3e72cc3f71cd4071cf4070d0416fd2426fd3436ed5446dd6456cd8456cd9466bdb476adc4869de4968df4a68e04c67e24d66e34e65e44f64e55064e75263e85362e95462ea5661eb5760ec5860ed5a5fee5b5eef5d5ef05f5ef1605df2625df2645cf3655cf4675cf4695cf56b5cf66c5cf66e5cf7705cf7725cf8745cf8765cf9785df9795df97b5dfa7d5efa7f5efa815ffb835ffb8560fb8761fc8961fc8a62fc8c63fc8e64fc9065fd9266fd9467fd9668fd9869fd9a6afd9b6bfe9d6cfe9f6dfea16efea36ffea571fea772fea973feaa74feac76feae77feb078feb27afeb47bfeb67cfeb77efeb97ffebb81febd82febf84fec185fec287fec488fec68afec88cfeca8dfecc8ffecd90fecf92fed194fed395fed597fed799fed89afdda9cfddc9efddea0fde0a1fde2a3fde3a5fde5a7fde7a9fde9aafdebacfcecaefceeb0fcf0b2fcf2b4fcf4b6fcf6b8fcf7b9fcf9bbfcfbbdfcfdbf")),PE=Nh(no("00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c431e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f3609613809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f24699025689225689326679526679727669827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305cb0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4ec63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3ed94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602de9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1fcffa4")),IE=Nh(no("0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e05952f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a66100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a87801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba58e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9ba21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8eb42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72d24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844bf3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983ef99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724f0f921"));function LE(n){let e=/^#(..)(..)(..)$/.exec(n),t=e?e.slice(1).map(i=>parseInt(i,16)):(n.match(/[\d.]+/g)??[]).map(Number);return[t[0]??0,t[1]??0,t[2]??0]}var si=256;function tr(n){let e={viridis:Cp,cividis:Ep,blue_red:i=>Ap(1-i)}[n],t=new Uint8Array(4*si);for(let i=0;i<si;i++)t.set([...LE(e(i/(si-1))),255],4*i);return t}var er=[{name:"no outlier",color:[208,212,218]},{name:"too far away after registration",color:[230,159,0]},{name:"its neighbors map elsewhere",color:[0,114,178]},{name:"both",color:[213,94,0]},{name:"the target has nothing there",color:[86,60,92]}];function Bx(){let n=new Uint8Array(4*si);for(let e=0;e<si;e++){let t=er[Math.min(er.length-1,Math.floor(e/si*er.length))];n.set([...t?.color??[0,0,0],255],4*e)}return n}var kx=([n,e,t])=>`rgb(${n}, ${e}, ${t})`,zx=n=>(n+.5)/er.length;var Hl=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},Vx=10,NE=13,ao=32;function Rp(n){}function Wx(n){if(typeof n=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=Rp,onError:t=Rp,onRetry:i=Rp,onComment:s,maxBufferSize:r}=n,o=[],a=0,l=!0,c,u="",h=0,f,d=!1;function y(T){if(d)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,T.charCodeAt(0)===239&&T.charCodeAt(1)===187&&T.charCodeAt(2)===191&&(T=T.slice(3))),o.length===0){let w=g(T);w!==""&&(o.push(w),a=w.length),v();return}if(T.indexOf(`
`)===-1&&T.indexOf("\r")===-1){o.push(T),a+=T.length,v();return}o.push(T);let b=o.join("");o.length=0,a=0;let m=g(b);m!==""&&(o.push(m),a=m.length),v()}function v(){r!==void 0&&(a+u.length<=r||(d=!0,o.length=0,a=0,c=void 0,u="",h=0,f=void 0,t(new Hl(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function g(T){let b=0;if(T.indexOf("\r")===-1){let m=T.indexOf(`
`,b);for(;m!==-1;){if(b===m){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0,b=m+1,m=T.indexOf(`
`,b);continue}let w=T.charCodeAt(b);if(Gx(T,b,w)){let R=T.charCodeAt(b+5)===ao?b+6:b+5,C=T.slice(R,m);if(h===0&&T.charCodeAt(m+1)===Vx){e({id:c,event:f,data:C}),c=void 0,u="",f=void 0,b=m+2,m=T.indexOf(`
`,b);continue}u=h===0?C:`${u}
${C}`,h++}else Hx(T,b,w)?f=T.slice(T.charCodeAt(b+6)===ao?b+7:b+6,m)||void 0:x(T,b,m);b=m+1,m=T.indexOf(`
`,b)}return T.slice(b)}for(;b<T.length;){let m=T.indexOf("\r",b),w=T.indexOf(`
`,b),R=-1;if(m!==-1&&w!==-1?R=m<w?m:w:m!==-1?m===T.length-1?R=-1:R=m:w!==-1&&(R=w),R===-1)break;x(T,b,R),b=R+1,T.charCodeAt(b-1)===NE&&T.charCodeAt(b)===Vx&&b++}return T.slice(b)}function x(T,b,m){if(b===m){M();return}let w=T.charCodeAt(b);if(Gx(T,b,w)){let D=T.charCodeAt(b+5)===ao?b+6:b+5,z=T.slice(D,m);u=h===0?z:`${u}
${z}`,h++;return}if(Hx(T,b,w)){f=T.slice(T.charCodeAt(b+6)===ao?b+7:b+6,m)||void 0;return}if(w===105&&T.charCodeAt(b+1)===100&&T.charCodeAt(b+2)===58){let D=T.slice(T.charCodeAt(b+3)===ao?b+4:b+3,m);D.includes("\0")||(c=D);return}if(w===58){if(s){let D=T.slice(b,m);s(D.slice(T.charCodeAt(b+1)===ao?2:1))}return}let R=T.slice(b,m),C=R.indexOf(":");if(C===-1){_(R,"",R);return}let I=R.slice(0,C),E=R.charCodeAt(C+1)===ao?2:1,F=R.slice(C+E);_(I,F,R)}function _(T,b,m){switch(T){case"event":f=b||void 0;break;case"data":u=h===0?b:`${u}
${b}`,h++;break;case"id":b.includes("\0")||(c=b);break;case"retry":/^\d+$/.test(b)?i(parseInt(b,10)):t(new Hl(`Invalid \`retry\` value: "${b}"`,{type:"invalid-retry",value:b,line:m}));break;default:t(new Hl(`Unknown field "${T.length>20?`${T.slice(0,20)}…`:T}"`,{type:"unknown-field",field:T,value:b,line:m}));break}}function M(){h>0&&e({id:c,event:f,data:u}),c=void 0,u="",h=0,f=void 0}function S(T={}){if(T.consume&&o.length>0){let b=o.join("");x(b,0,b.length)}l=!0,c=void 0,u="",h=0,f=void 0,o.length=0,a=0,d=!1}return{feed:y,reset:S}}function Gx(n,e,t){return t===100&&n.charCodeAt(e+1)===97&&n.charCodeAt(e+2)===116&&n.charCodeAt(e+3)===97&&n.charCodeAt(e+4)===58}function Hx(n,e,t){return t===101&&n.charCodeAt(e+1)===118&&n.charCodeAt(e+2)===101&&n.charCodeAt(e+3)===110&&n.charCodeAt(e+4)===116&&n.charCodeAt(e+5)===58}var Dh=class extends TransformStream{constructor({onError:e,onRetry:t,onComment:i,maxBufferSize:s}={}){let r;super({start(o){r=Wx({onEvent:a=>{o.enqueue(a)},onError(a){typeof e=="function"&&e(a),(e==="terminate"||a.type==="max-buffer-size-exceeded")&&o.error(a)},onRetry:t,onComment:i,maxBufferSize:s})},transform(o){r.feed(o)}})}};function lo(n,e){return!n||n.id!==e.id?e:Kn(n.state)&&!Kn(e.state)?n:n.cancel_requested&&!e.cancel_requested?{...e,cancel_requested:!0}:e}var Jn=(n,e)=>new Promise(t=>{let i=()=>{clearTimeout(s),e.removeEventListener("abort",i),t()},s=setTimeout(i,n);e.addEventListener("abort",i)}),xa=n=>n instanceof zn&&n.problem.status<500&&n.problem.status!==429;async function ri(n,e){for(let t=500;;t=Math.min(t*2,8e3)){try{return await n()}catch(i){if(e.aborted||xa(i))throw i}await Jn(t,e),e.throwIfAborted()}}var DE=4e4,FE=30;async function $x(n,e,t){let i,s=0,r=500;for(;!t.aborted;){let o=new AbortController,a=()=>o.abort();t.addEventListener("abort",a,{once:!0});let l=0;try{let c={accept:"text/event-stream"};i!==void 0&&(c["last-event-id"]=i);let u=await Mn(`v1/jobs/${n}/events?fields=*`,{headers:c,signal:o.signal,cache:"no-store"});if(u.status===204||u.body===null)return;e.connected(!0),r=500;let h=()=>{clearTimeout(l),l=window.setTimeout(a,DE)},f=new TransformStream({transform(x,_){h(),_.enqueue(x)}}),d=new TextDecoderStream,v=u.body.pipeThrough(f).pipeThrough(d).pipeThrough(new Dh).getReader(),g=performance.now();for(;;){let{done:x,value:_}=await v.read();if(x)break;performance.now()-g>FE&&(await Jn(0,o.signal),g=performance.now()),_.id!==void 0&&(i=_.id);let M=JSON.parse(_.data);if(_.event==="trace"){let S=M;S.seq>s&&(s=S.seq,e.trace([S]))}else if(_.event==="progress")e.progress(M.progress??M);else if(e.job(M),_.event==="done")return}}catch(c){if(t.aborted)return;if(xa(c)){e.failed(c);return}}finally{clearTimeout(l),t.removeEventListener("abort",a)}e.connected(!1),await Jn(r,t),r=Math.min(r*2,8e3)}}async function Xx(n,e,t,i){let s,r=500;for(;!i.aborted;)try{if(s===void 0){let a=await OE(i);await n(),s=a}let o=await vt(`v1/changes?since=${s}&wait=20`,i);t(!0),r=500,s=o.next_since,o.changes.length>0&&e(o.changes)}catch(o){if(i.aborted||(t(!1),o instanceof zn&&o.problem.status===401))return;await Jn(r,i),r=Math.min(r*2,8e3)}}async function OE(n){let e=async s=>(await vt(`v1/changes?since=${s}&limit=1`,n)).changes.length>0,[t,i]=[-1,0];for(;await e(i);)[t,i]=[i,Math.max(1,i*4)];for(;i-t>1;){let s=Math.floor((t+i)/2);await e(s)?t=s:i=s}return i}function ya(n,e=[]){let t=new Sh,i=new TextDecoder().decode(n.slice(0,4096)).split("end_header")[0]??"",s=e.filter(a=>new RegExp(`^property \\w+ ${a}\\s*$`,"m").test(i));t.setCustomPropertyNameMapping(Object.fromEntries(s.map(a=>[a,[a]])));let r=t.parse(n),o={};for(let a of s)o[a]=Float32Array.from(r.getAttribute(a).array),r.deleteAttribute(a);return r.setAttribute("position",new Ft(Float32Array.from(r.getAttribute("position").array),3)),r.computeVertexNormals(),r.computeBoundingSphere(),{geometry:r,rows:o}}var UE=["target","confidence","inlier","spread_mm","outlier","triangle_0","triangle_1","triangle_2","barycentric_0","barycentric_1","barycentric_2"];async function qx(n,e){let t=`v1/jobs/${n.id}`,i=async a=>(await Mn(`${t}/${a}`,{signal:e})).arrayBuffer(),[s,r,o]=await Promise.all([ri(()=>vt(`${t}/result?correspondences=false`,e),e),ri(()=>i("correspondences?format=ply"),e),ri(()=>i("surfaces/target?format=ply"),e)]);return{pair:BE(s,r,o),result:s}}function BE(n,e,t){let{geometry:i,rows:s}=ya(e,UE),{geometry:r}=ya(t),o=i.getAttribute("position").count,a=new Float32Array(o),l=E=>s[E]??a,[c,u]=[i.getAttribute("position"),r.getAttribute("position")],h=n.transform.matrix.flat(),f=new Je().set(...h),d=[l("triangle_0"),l("triangle_1"),l("triangle_2")],y=[l("barycentric_0"),l("barycentric_1"),l("barycentric_2")],v=new Float32Array(3*o),g=new Int32Array(o),x=l("outlier"),_={confidence:new Float32Array(o),residual:new Float32Array(o),displacement:new Float32Array(o),spread:new Float32Array(o),outlier:new Float32Array(o)},[M,S,T]=[new H,new H,i.getAttribute("normal")];for(let E=0;E<o;E++){let F=x[E]===4;for(let D=0;D<3;D++){let z=0;for(let X=0;X<3;X++)z+=(y[X]?.[E]??0)*u.getComponent(d[X]?.[E]??0,D);v[3*E+D]=z}g[E]=F?-1:l("target")[E]??-1,M.fromBufferAttribute(c,E).applyMatrix4(f),S.fromBufferAttribute(T,E).transformDirection(f),M.set(v[3*E]-M.x,v[3*E+1]-M.y,v[3*E+2]-M.z),_.confidence[E]=F?NaN:l("confidence")[E]??NaN,_.spread[E]=F?NaN:l("spread_mm")[E]??NaN,_.residual[E]=F?NaN:M.length(),_.displacement[E]=F?NaN:M.dot(S),_.outlier[E]=zx(x[E]??0)}let b=Object.fromEntries(Object.keys(_).map(E=>[E,kE(_[E],E==="outlier",d,y,g,r)])),m=u.count,w=new Uint32Array(m+1);g.forEach(E=>E>=0&&w[E+1]++);for(let E=0;E<m;E++)w[E+1]+=w[E];let R=w.slice(0,m),C=new Uint32Array(w[m]);g.forEach((E,F)=>E>=0&&(C[R[E]++]=F));let I=Uint8Array.from(l("inlier"));return{source:i,target:r,targetFromSource:f,images:v,nearest:g,inlier:I,columns:_,onTarget:b,starts:w,sources:C,frame:Cs(r)}}function kE(n,e,t,i,s,r){let o=r.getAttribute("position").count,a=new Float32Array(o).fill(NaN);if(e)s.forEach((c,u)=>c>=0&&(a[c]=Math.max(Number.isNaN(a[c])?0:a[c],n[u])));else{let[c,u]=[new Float64Array(o),new Float64Array(o)];for(let h=0;h<n.length;h++)if(!Number.isNaN(n[h]))for(let f=0;f<3;f++){let[d,y]=[t[f][h],i[f][h]];c[d]+=y*n[h],u[d]+=y}for(let h=0;h<o;h++)u[h]>1e-9&&(a[h]=c[h]/u[h])}let l=r.getIndex();for(let c=0;c<2;c++){let[u,h]=[new Float64Array(o),new Uint16Array(o)];for(let f=0;f<l.count;f+=3)for(let d=0;d<3;d++){let y=a[l.getX(f+d)];if(!Number.isNaN(y))for(let v=0;v<3;v++){let g=l.getX(f+v);u[g]=e?Math.max(u[g],y):u[g]+y,h[g]++}}for(let f=0;f<o;f++)Number.isNaN(a[f])&&h[f]>0&&(a[f]=e?u[f]:u[f]/h[f])}return a}function Cs(n){let e=n.getAttribute("position"),t=new H,i=new H;for(let h=0;h<e.count;h++)t.add(i.fromBufferAttribute(e,h));t.divideScalar(Math.max(1,e.count));let s=[0,0,0,0,0,0,0,0,0];for(let h=0;h<e.count;h++){let f=i.fromBufferAttribute(e,h).sub(t).toArray();for(let d=0;d<3;d++)for(let y=0;y<3;y++)s[3*d+y]+=f[d]*f[y]}let r=[1,0,0,0,1,0,0,0,1];for(let h=0;h<12;h++)for(let[f,d]of[[0,1],[0,2],[1,2]]){let y=s[3*f+d];if(Math.abs(y)<1e-12)continue;let v=.5*Math.atan2(2*y,s[3*d+d]-s[3*f+f]),[g,x]=[Math.cos(v),Math.sin(v)];for(let _=0;_<3;_++){let[M,S]=[s[3*_+f],s[3*_+d]];s[3*_+f]=g*M-x*S,s[3*_+d]=x*M+g*S}for(let _=0;_<3;_++){let[M,S]=[s[3*f+_],s[3*d+_]];s[3*f+_]=g*M-x*S,s[3*d+_]=x*M+g*S;let[T,b]=[r[3*_+f],r[3*_+d]];r[3*_+f]=g*T-x*b,r[3*_+d]=x*T+g*b}}let o=[0,1,2].sort((h,f)=>s[4*f]-s[4*h]),a=h=>new H(r[o[h]],r[3+o[h]],r[6+o[h]]).normalize(),[l,c]=[a(0),a(1)],u=[l,c,new H().crossVectors(l,c)];return Yx(n,t,u)}function Yx(n,e,t){let i=n.getAttribute("position"),[s,r]=[new H(1/0,1/0,1/0),new H(-1/0,-1/0,-1/0)],[o,a]=[new H,new H];for(let l=0;l<i.count;l++)o.fromBufferAttribute(i,l).sub(e),a.set(o.dot(t[0]),o.dot(t[1]),o.dot(t[2])),s.min(a),r.max(a);return{center:e,axes:t,low:s,high:r}}function jx(n,e){let t=Cs(e),[i,s]=[n.getAttribute("position"),e.getAttribute("position")];if(i.count!==s.count)return Cs(n);let r=new H,[o,a]=[new H,new H];for(let u=0;u<i.count;u++)r.add(o.fromBufferAttribute(i,u));r.divideScalar(Math.max(1,i.count));let l=[0,0,0,0,0,0,0,0,0];for(let u=0;u<i.count;u++){let[h,f]=[o.fromBufferAttribute(i,u).sub(r).toArray(),a.fromBufferAttribute(s,u).sub(t.center).toArray()];for(let d=0;d<3;d++)for(let y=0;y<3;y++)l[3*d+y]+=h[d]*f[y]}let c=new it().set(...l);c.multiplyScalar(1/(Math.cbrt(Math.abs(c.determinant()))||1));for(let u=0;u<30;u++){let h=c.clone().invert().transpose();for(let f=0;f<9;f++)c.elements[f]=(c.elements[f]+h.elements[f])/2}return Math.abs(c.determinant()-1)<.01?Yx(n,r,t.axes.map(u=>u.clone().applyMatrix3(c))):Cs(n)}function Pp(n,e,t){let i=e.length/3,s=new Float32Array(3*i),r=new H,o=Math.max(1e-9,n.high.x-n.low.x);for(let a=0;a<i;a++)r.set(e[3*a],e[3*a+1],e[3*a+2]).sub(n.center),s[3*a]=t(a)?(r.dot(n.axes[0])-n.low.x)/o:-1,s[3*a+1]=r.dot(n.axes[1]),s[3*a+2]=r.dot(n.axes[2]);return new Ft(s,3)}function Fh(n,e){let t=n.filter(i=>!Number.isNaN(i)).sort();return t[Math.min(t.length-1,Math.floor(e*t.length))]??1}var Ip={type:"change"},Dp={type:"start"},Fp={type:"end"},Oh=1e-6,Lt={NONE:-1,ROTATE:0,ZOOM:1,PAN:2,TOUCH_ROTATE:3,TOUCH_ZOOM_PAN:4},Uh=new Qe,Rr=new Qe,zE=new H,Bh=new H,Lp=new H,Pr=new fn,kh=new H,zh=new H,Np=new H,Vh=new H,Ir=class extends Al{constructor(e,t=null){super(e,t),this.screen={left:0,top:0,width:0,height:0},this.rotateSpeed=1,this.zoomSpeed=1.2,this.panSpeed=.3,this.rollSpeed=1,this.noRotate=!1,this.noZoom=!1,this.noPan=!1,this.multiTouchRoll=!1,this.staticMoving=!1,this.dynamicDampingFactor=.2,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.keys=["KeyA","KeyS","KeyD"],this.mouseButtons={LEFT:Tr.ROTATE,MIDDLE:Tr.DOLLY,RIGHT:Tr.PAN},this.target=new H,this.state=Lt.NONE,this.keyState=Lt.NONE,this._lastPosition=new H,this._lastUp=new H,this._lastZoom=1,this._touchZoomDistanceStart=0,this._touchZoomDistanceEnd=0,this._touchRollAngle=0,this._touchRollPointerIds="",this._lastAngle=0,this._lastRollAngle=0,this._eye=new H,this._movePrev=new Qe,this._moveCurr=new Qe,this._lastAxis=new H,this._zoomStart=new Qe,this._zoomEnd=new Qe,this._panStart=new Qe,this._panEnd=new Qe,this._pointers=[],this._pointerPositions={},this._onPointerMove=GE.bind(this),this._onPointerDown=VE.bind(this),this._onPointerUp=HE.bind(this),this._onPointerCancel=WE.bind(this),this._onContextMenu=ZE.bind(this),this._onMouseWheel=JE.bind(this),this._onKeyDown=XE.bind(this),this._onKeyUp=$E.bind(this),this._onTouchStart=KE.bind(this),this._onTouchMove=QE.bind(this),this._onTouchEnd=eC.bind(this),this._onMouseDown=qE.bind(this),this._onMouseMove=YE.bind(this),this._onMouseUp=jE.bind(this),this._target0=this.target.clone(),this._position0=this.object.position.clone(),this._up0=this.object.up.clone(),this._zoom0=this.object.zoom,t!==null&&(this.connect(t),this.handleResize()),this.update()}connect(e){super.connect(e),window.addEventListener("keydown",this._onKeyDown),window.addEventListener("keyup",this._onKeyUp),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerCancel),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction="none"}disconnect(){window.removeEventListener("keydown",this._onKeyDown),window.removeEventListener("keyup",this._onKeyUp),this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerCancel),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.domElement.style.touchAction=""}dispose(){this.disconnect()}handleResize(){let e=this.domElement.getBoundingClientRect(),t=this.domElement.ownerDocument.documentElement;this.screen.left=e.left+window.pageXOffset-t.clientLeft,this.screen.top=e.top+window.pageYOffset-t.clientTop,this.screen.width=e.width,this.screen.height=e.height}update(){if(this._eye.subVectors(this.object.position,this.target),this.noRotate||(this._rotateCamera(),this.multiTouchRoll===!0&&this._rollCamera()),this.noZoom||this._zoomCamera(),this.noPan||this._panCamera(),this.object.position.addVectors(this.target,this._eye),this.object.isPerspectiveCamera){this._checkDistances(),this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Oh,t=this._lastUp.distanceToSquared(this.object.up)>Oh;(e||t)&&(this.dispatchEvent(Ip),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up))}else if(this.object.isOrthographicCamera){this.object.lookAt(this.target);let e=this._lastPosition.distanceToSquared(this.object.position)>Oh,t=this._lastUp.distanceToSquared(this.object.up)>Oh,i=this._lastZoom!==this.object.zoom;(e||t||i)&&(this.dispatchEvent(Ip),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom)}else console.warn("THREE.TrackballControls: Unsupported camera type.")}reset(){this.state=Lt.NONE,this.keyState=Lt.NONE,this.target.copy(this._target0),this.object.position.copy(this._position0),this.object.up.copy(this._up0),this.object.zoom=this._zoom0,this.object.updateProjectionMatrix(),this._eye.subVectors(this.object.position,this.target),this.object.lookAt(this.target),this.dispatchEvent(Ip),this._lastPosition.copy(this.object.position),this._lastUp.copy(this.object.up),this._lastZoom=this.object.zoom}_panCamera(){if(Rr.copy(this._panEnd).sub(this._panStart),Rr.lengthSq()){if(this.object.isOrthographicCamera){let e=(this.object.right-this.object.left)/this.object.zoom/this.domElement.clientWidth,t=(this.object.top-this.object.bottom)/this.object.zoom/this.domElement.clientWidth;Rr.x*=e,Rr.y*=t}Rr.multiplyScalar(this._eye.length()*this.panSpeed),Bh.copy(this._eye).cross(this.object.up).setLength(Rr.x),Bh.add(zE.copy(this.object.up).setLength(Rr.y)),this.object.position.add(Bh),this.target.add(Bh),this.staticMoving?this._panStart.copy(this._panEnd):this._panStart.add(Rr.subVectors(this._panEnd,this._panStart).multiplyScalar(this.dynamicDampingFactor))}}_rotateCamera(){Vh.set(this._moveCurr.x-this._movePrev.x,this._moveCurr.y-this._movePrev.y,0);let e=Vh.length();e?(this._eye.copy(this.object.position).sub(this.target),kh.copy(this._eye).normalize(),zh.copy(this.object.up).normalize(),Np.crossVectors(zh,kh).normalize(),zh.setLength(this._moveCurr.y-this._movePrev.y),Np.setLength(this._moveCurr.x-this._movePrev.x),Vh.copy(zh.add(Np)),Lp.crossVectors(Vh,this._eye).normalize(),e*=this.rotateSpeed,Pr.setFromAxisAngle(Lp,e),this._eye.applyQuaternion(Pr),this.object.up.applyQuaternion(Pr),this._lastAxis.copy(Lp),this._lastAngle=e):!this.staticMoving&&this._lastAngle&&(this._lastAngle*=Math.sqrt(1-this.dynamicDampingFactor),this._eye.copy(this.object.position).sub(this.target),Pr.setFromAxisAngle(this._lastAxis,this._lastAngle),this._eye.applyQuaternion(Pr),this.object.up.applyQuaternion(Pr)),this._movePrev.copy(this._moveCurr)}_rollCamera(){let e=this._getTouchRollAngle();if(e)this._lastRollAngle=e*this.rollSpeed;else if(!this.staticMoving&&this._lastRollAngle)this._lastRollAngle*=Math.sqrt(1-this.dynamicDampingFactor);else return;kh.copy(this._eye).normalize(),Pr.setFromAxisAngle(kh,this._lastRollAngle),this.object.up.applyQuaternion(Pr)}_getTouchRollAngle(){let e=this._pointers[0],t=this._pointers[1];if(t===void 0||e.pointerType!=="touch"||t.pointerType!=="touch")return this._touchRollPointerIds="",0;let i=`${e.pointerId},${t.pointerId}`,s=this._pointerPositions[e.pointerId],r=this._pointerPositions[t.pointerId],o=Math.atan2(r.y-s.y,r.x-s.x);if(i!==this._touchRollPointerIds)return this._touchRollPointerIds=i,this._touchRollAngle=o,0;let a=o-this._touchRollAngle;return this._touchRollAngle=o,a>Math.PI?a-=2*Math.PI:a<-Math.PI&&(a+=2*Math.PI),a}_zoomCamera(){let e;this.state===Lt.TOUCH_ZOOM_PAN?(e=this._touchZoomDistanceStart/this._touchZoomDistanceEnd,this._touchZoomDistanceStart=this._touchZoomDistanceEnd,this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=gh.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")):(e=1+(this._zoomEnd.y-this._zoomStart.y)*this.zoomSpeed,e!==1&&e>0&&(this.object.isPerspectiveCamera?this._eye.multiplyScalar(e):this.object.isOrthographicCamera?(this.object.zoom=gh.clamp(this.object.zoom/e,this.minZoom,this.maxZoom),this._lastZoom!==this.object.zoom&&this.object.updateProjectionMatrix()):console.warn("THREE.TrackballControls: Unsupported camera type")),this.staticMoving?this._zoomStart.copy(this._zoomEnd):this._zoomStart.y+=(this._zoomEnd.y-this._zoomStart.y)*this.dynamicDampingFactor)}_getMouseOnScreen(e,t){return Uh.set((e-this.screen.left)/this.screen.width,(t-this.screen.top)/this.screen.height),Uh}_getMouseOnCircle(e,t){return Uh.set((e-this.screen.width*.5-this.screen.left)/(this.screen.width*.5),(this.screen.height+2*(this.screen.top-t))/this.screen.width),Uh}_addPointer(e){this._pointers.push(e)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t].pointerId==e.pointerId){this._pointers.splice(t,1);return}}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Qe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0].pointerId?this._pointers[1]:this._pointers[0];return this._pointerPositions[t.pointerId]}_checkDistances(){(!this.noZoom||!this.noPan)&&(this._eye.lengthSq()>this.maxDistance*this.maxDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.maxDistance)),this._zoomStart.copy(this._zoomEnd)),this._eye.lengthSq()<this.minDistance*this.minDistance&&(this.object.position.addVectors(this.target,this._eye.setLength(this.minDistance)),this._zoomStart.copy(this._zoomEnd)))}};function VE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n))}function GE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function HE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchEnd(n):this._onMouseUp(),this._removePointer(n),this._pointers.length===0&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp)))}function WE(n){this._removePointer(n)}function $E(){this.enabled!==!1&&(this.keyState=Lt.NONE,window.addEventListener("keydown",this._onKeyDown))}function XE(n){this.enabled!==!1&&(window.removeEventListener("keydown",this._onKeyDown),this.keyState===Lt.NONE&&(n.code===this.keys[Lt.ROTATE]&&!this.noRotate?this.keyState=Lt.ROTATE:n.code===this.keys[Lt.ZOOM]&&!this.noZoom?this.keyState=Lt.ZOOM:n.code===this.keys[Lt.PAN]&&!this.noPan&&(this.keyState=Lt.PAN)))}function qE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Tr.DOLLY:this.state=Lt.ZOOM;break;case Tr.ROTATE:this.state=Lt.ROTATE;break;case Tr.PAN:this.state=Lt.PAN;break;default:this.state=Lt.NONE}let t=this.keyState!==Lt.NONE?this.keyState:this.state;t===Lt.ROTATE&&!this.noRotate?(this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr)):t===Lt.ZOOM&&!this.noZoom?(this._zoomStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._zoomEnd.copy(this._zoomStart)):t===Lt.PAN&&!this.noPan&&(this._panStart.copy(this._getMouseOnScreen(n.pageX,n.pageY)),this._panEnd.copy(this._panStart)),this.dispatchEvent(Dp)}function YE(n){let e=this.keyState!==Lt.NONE?this.keyState:this.state;e===Lt.ROTATE&&!this.noRotate?this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)):e===Lt.ZOOM&&!this.noZoom?this._zoomEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY)):e===Lt.PAN&&!this.noPan&&this._panEnd.copy(this._getMouseOnScreen(n.pageX,n.pageY))}function jE(){this.state=Lt.NONE,this.dispatchEvent(Fp)}function JE(n){if(this.enabled!==!1&&this.noZoom!==!0){switch(n.preventDefault(),n.deltaMode){case 2:this._zoomStart.y-=n.deltaY*.025;break;case 1:this._zoomStart.y-=n.deltaY*.01;break;default:this._zoomStart.y-=n.deltaY*25e-5;break}this.dispatchEvent(Dp),this.dispatchEvent(Fp)}}function ZE(n){this.enabled!==!1&&n.preventDefault()}function KE(n){if(this._trackPointer(n),this._pointers.length===1)this.state=Lt.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(this._pointers[0].pageX,this._pointers[0].pageY)),this._movePrev.copy(this._moveCurr);else{this.state=Lt.TOUCH_ZOOM_PAN;let e=this._pointers[0].pageX-this._pointers[1].pageX,t=this._pointers[0].pageY-this._pointers[1].pageY;this._touchZoomDistanceEnd=this._touchZoomDistanceStart=Math.sqrt(e*e+t*t);let i=(this._pointers[0].pageX+this._pointers[1].pageX)/2,s=(this._pointers[0].pageY+this._pointers[1].pageY)/2;this._panStart.copy(this._getMouseOnScreen(i,s)),this._panEnd.copy(this._panStart)}this.dispatchEvent(Dp)}function QE(n){if(this._trackPointer(n),this._pointers.length===1)this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY));else{let e=this._getSecondPointerPosition(n),t=n.pageX-e.x,i=n.pageY-e.y;this._touchZoomDistanceEnd=Math.sqrt(t*t+i*i);let s=(n.pageX+e.x)/2,r=(n.pageY+e.y)/2;this._panEnd.copy(this._getMouseOnScreen(s,r))}}function eC(n){switch(this._pointers.length){case 0:this.state=Lt.NONE;break;case 1:this.state=Lt.TOUCH_ROTATE,this._moveCurr.copy(this._getMouseOnCircle(n.pageX,n.pageY)),this._movePrev.copy(this._moveCurr);break;case 2:this.state=Lt.TOUCH_ZOOM_PAN;for(let e=0;e<this._pointers.length;e++)if(this._pointers[e].pointerId!==n.pointerId){let t=this._pointerPositions[this._pointers[e].pointerId];this._moveCurr.copy(this._getMouseOnCircle(t.x,t.y)),this._movePrev.copy(this._moveCurr);break}break}this.dispatchEvent(Fp)}var tC=`
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
  }`,nC=`
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
  }`,Op=new Wt(0,0,0,1);function Gh(n){let e={map:{value:n},low:{value:0},top:{value:1},opacity:{value:1},byPlace:{value:!0},grid:{value:!0},section:{value:Op.clone()},pose:{value:new Je}};return new Gi({vertexShader:tC,fragmentShader:nC,uniforms:e,side:mi})}function Jx(n){let e=new Ys(tr(n),si,1);return e.needsUpdate=!0,e}function Up(n){let e=n.getAttribute("position").count;n.hasAttribute("value")||n.setAttribute("value",new Ft(new Float32Array(e).fill(-1e9),1));let t=Gh(Jx("viridis"));return t.uniforms.byPlace.value=!1,t.uniforms.grid.value=!1,new Tn(n,t)}function Bp(n,{values:e,low:t,high:i,map:s}){let{uniforms:r}=n.material;r.map.value.dispose(),r.map.value=Jx(s),r.low.value=t,r.top.value=Math.max(i,t+1e-12);let o=n.geometry.getAttribute("value");for(let a=0;a<o.count;a++)o.array[a]=Number.isFinite(e[a])?e[a]:-1e9;o.needsUpdate=!0}function kp(n,e,t){n.up.copy(e.axes[1]),n.position.copy(e.center).addScaledVector(e.axes[2],4*t),[n.near,n.far,n.zoom]=[-20*t,40*t,1],n.lookAt(e.center)}function zp(n,e,t,i){let{low:s,high:r}=e,o=Math.max(2.2*Math.max(-s.x,r.x)/t,2.3*Math.max(-s.y,r.y,-s.z,r.z)/i);[n.left,n.right,n.top,n.bottom]=[-t,t,i,-i].map(a=>a*o/2),n.updateProjectionMatrix()}var Hh=class{constructor(e,t){this.canvas=e;this.renderer=new Ts({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.mesh=Up(t),this.mesh.frustumCulled=!1,this.scene.add(this.mesh),this.frame=Cs(t),this.radius=t.boundingSphere?.radius||1,this.controls=new Ir(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.sizes.observe(e);let i=()=>{this.waiting=requestAnimationFrame(i),this.controls.update(),this.isDirty&&this.draw()};i()}canvas;renderer;camera=new Li;controls;scene=new es;mesh;frame;radius;sizes=new ResizeObserver(()=>this.resize());waiting=0;isDirty=!0;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.mesh.material.dispose(),this.mesh.geometry.dispose(),this.renderer.dispose()}color(e){Bp(this.mesh,e),this.redraw()}move(e){let t=this.mesh.geometry.getAttribute("position");t.array.set(e),t.needsUpdate=!0,this.mesh.geometry.computeVertexNormals(),this.mesh.geometry.computeBoundingSphere(),this.redraw()}view(){this.controls.target.copy(this.frame.center),kp(this.camera,this.frame,this.radius),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new H().crossVectors(this.camera.up,i).normalize(),r=new fn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new fn().setFromAxisAngle(s,t)),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i.applyQuaternion(r)),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}redraw(){this.isDirty=!0}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),zp(this.camera,this.frame,e,t),this.controls.handleResize(),this.redraw())}draw(){this.isDirty=!1,this.renderer.setClearColor(new rt(getComputedStyle(this.canvas).getPropertyValue("--canvas").trim()||"#f4f6f8")),this.renderer.render(this.scene,this.camera)}pick(e,t){let i=new Jr,{clientWidth:s,clientHeight:r}=this.canvas;this.camera.updateMatrixWorld(),i.setFromCamera(new Qe(2*e/s-1,1-2*t/r),this.camera);let o=i.intersectObject(this.mesh)[0];if(!o?.face)return null;let a=this.mesh.geometry.getAttribute("position"),l=c=>o.point.distanceToSquared(new H().fromBufferAttribute(a,c));return[o.face.a,o.face.b,o.face.c].reduce((c,u)=>l(u)<l(c)?u:c)}project(e){this.camera.updateMatrixWorld();let{geometry:t}=this.mesh,i=new H().fromBufferAttribute(t.getAttribute("position"),e).project(this.camera),s=new H().fromBufferAttribute(t.getAttribute("normal"),e),r=new H().setFromMatrixColumn(this.camera.matrixWorld,2);return{x:(i.x+1)/2*this.canvas.clientWidth,y:(1-i.y)/2*this.canvas.clientHeight,facing:s.dot(r)}}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var[Vp,Gp]=[84,38],iC=500,sC=250,nr,va=new Map,Zx=Promise.resolve();function rC({geometry:n,coloring:e,frame:t=Cs(n)}){if(nr===void 0)try{nr=new Ts({antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),nr.setPixelRatio(2),nr.setSize(Vp,Gp,!1)}catch{nr=null}if(nr===null)return null;let[i,s,r]=[Up(n),new es,new Li];return e&&Bp(i,e),s.add(i),kp(r,t,n.boundingSphere?.radius||1),zp(r,t,Vp,Gp),nr.setClearColor(0,0),nr.render(s,r),i.material.uniforms.map.value.dispose(),i.material.dispose(),n.dispose(),nr.domElement.toDataURL()}function Wh({name:n,alt:e,load:t}){let i=wt(null),[s,r]=ae(!1),[o,a]=ae(va.get(n)??null);return ct(()=>{let l=0,c=new IntersectionObserver(u=>{clearTimeout(l),u.at(-1).isIntersecting&&(l=window.setTimeout(()=>r(!0),sC))});return c.observe(i.current),()=>{clearTimeout(l),c.disconnect()}},[]),Vt(l=>{a(va.get(n)??null),!(!s||va.has(n))&&(Zx=Zx.then(async()=>{if(l.aborted)return;let c=await t(l).catch(()=>null),u=c===null||l.aborted?null:rC(c);u!==null&&(va.size>=iC&&va.clear(),va.set(n,u),a(u))}))},[n,s]),p("span",{class:"picture",ref:i,children:o!==null&&p("img",{src:o,width:Vp,height:Gp,alt:e})})}var Wl=new Map,oC=2e3,[Kx,Hp]=[78,20];function aC(n){let e=n.filter(({energy:t})=>t!==void 0);for(let t=e.length;t>0;){let i=gs(e[t-1]),s=t;for(;s>0&&gs(e[s-1])===i;)s--;if(t-s>1){let{phase:r,round:o}=e[s];return{values:e.slice(s,t).map(({energy:a})=>a),of:`${It(r)}, ${r==="displacement"?"fit":"round"} ${o}`}}t=s}return null}function lC(n){let e=n.every(s=>s>0)?n.map(Math.log):n,[t,i]=[Math.min(...e),Math.max(...e)];return e.map((s,r)=>`${(r/(e.length-1)*Kx+1).toFixed(1)},${(Hp+1-Hp*(s-t)/(i-t||1)).toFixed(1)}`).join(" ")}function Qx({id:n,state:e}){let[t,i]=ae(Wl.get(n)??null);if(Vt(r=>{let o=Wl.get(n);i(o??null),!(e==="queued"||o!==void 0&&Kn(e))&&Jn(250,r).then(async()=>{if(r.aborted)return;let a=await vt(`v1/jobs/${n}/trace?limit=200`,r).catch(()=>null);if(a===null||r.aborted)return;let l=aC(a.points);Wl.size>oC&&Wl.clear(),Kn(e)&&Wl.set(n,l),i(l)})},[n,e]),t===null)return null;let s=`Energy of the ${t.of}, from ${t.values[0].toPrecision(3)} to ${t.values.at(-1).toPrecision(3)}`;return p("svg",{class:"spark",width:Kx+2,height:Hp+2,role:"img","aria-label":s,children:[p("title",{children:s}),p("polyline",{points:lC(t.values)})]})}var cC=44;function uC(n,e){let[,t]=ae(0),i=wt(null),s={count:n,getScrollElement:()=>e.current,estimateSize:()=>cC,overscan:8,scrollToFn:e0,observeElementRect:Kg,observeElementOffset:Qg,onChange:()=>t(r=>r+1)};return i.current??=new Tc(s),i.current.setOptions(s),ct(()=>i.current._didMount(),[]),ct(()=>i.current._willUpdate()),i.current}async function hC({id:n,pictured:e},t){let i=await(await Mn(`v1/jobs/${n}/surfaces/${e}?format=ply`,{signal:t})).arrayBuffer();return{geometry:ya(i).geometry}}function Wp({tags:n}){let{source_file:e,target_file:t}=n;return e&&t?`${e} → ${t}`:e??t??""}function ey({rows:n,pictures:e,hasMore:t,more:i,renew:s,failed:r}){let o=wt(null),a=uC(n.length,o),l=ki(),c=a.getVirtualItems(),u=c.at(-1)?.index??0;ct(()=>{u>=n.length-12&&i?.()},[i===null,u,n.length]);let h=(x,_)=>{Vn("POST",`v1/jobs/${_}/${x}`).then(M=>x==="retry"?Ti(`jobs/${M.id}`):s([_]),r)},f=(x,_)=>Vn("PATCH",`v1/jobs/${x}`,{priority:_}).then(()=>s([x]),r),d=x=>{if(x.ctrlKey||x.altKey||x.metaKey)return;let _={ArrowDown:1,j:1,ArrowUp:-1,k:-1,PageDown:12,PageUp:-12}[x.key],M=x.target;if(_===void 0||M.tagName==="INPUT")return;let S=Number(M.closest("tr")?.dataset.index??-1),T=Math.min(n.length-1,Math.max(0,S+_));x.preventDefault(),a.scrollToIndex(T);let b=m=>{let w=o.current?.querySelector(`tr[data-index="${T}"] a`);w?w.focus():m>0&&requestAnimationFrame(()=>b(m-1))};requestAnimationFrame(()=>b(10))},y=wt(d);y.current=d,ct(()=>{let x=_=>(_.target===document.body||_.target===document.getElementById("main"))&&y.current(_);return window.addEventListener("keydown",x),()=>window.removeEventListener("keydown",x)},[]);let v=c[0]?.start??0,g=Math.max(0,a.getTotalSize()-(c.at(-1)?.end??0));return p("div",{class:"rows",ref:o,onKeyDown:d,tabIndex:0,role:"region","aria-label":"Jobs; arrow keys move from row to row, Enter opens one",children:p("table",{"aria-rowcount":t?-1:n.length+1,children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Job"}),e&&p("th",{scope:"col",children:"Shape"}),p("th",{scope:"col",children:"State"}),p("th",{scope:"col",children:"Verdict"}),p("th",{scope:"col",class:"numeric",children:"Distance"}),p("th",{scope:"col",children:"Energy"}),p("th",{scope:"col",children:"Method"}),p("th",{scope:"col",children:"Age"}),p("th",{scope:"col",children:"Ran for"}),p("th",{scope:"col",children:"Priority"}),p("th",{scope:"col",children:p("span",{class:"quiet",children:"Actions"})})]})}),p("tbody",{children:[v>0&&p("tr",{"aria-hidden":"true",style:{height:`${v}px`}}),c.map(({index:x})=>{let _=n[x];if(_===void 0)return null;let M=Sc(_);return p("tr",{"data-index":x,"data-state":_.state,"aria-rowindex":x+2,children:[p("td",{children:[p("a",{href:`#/jobs/${_.id}`,title:_.id,children:p("code",{children:["…",Qn(_.id)]})})," ",(_.external_ref||Wp(_))&&p("span",{class:"soft files",title:[_.external_ref,Wp(_)].filter(Boolean).join(": "),children:_.external_ref??Wp(_)}),_.batch_id&&p("a",{class:"soft",href:`#/batches/${_.batch_id}`,children:"batch"}),_.study_id&&p("a",{class:"soft",href:`#/studies/${_.study_id}`,children:"study"})]}),e&&p("td",{children:_.state==="succeeded"&&_.pictured&&p(Wh,{name:`job/${_.id}`,alt:`The ${_.pictured} of ${Qn(_.id)}`,load:S=>hC(_,S)})}),p("td",{children:[p(Lo,{state:_.state}),_.state==="running"&&p(wi,{share:_.progress?.fraction??0,label:`Progress: ${It(_.progress?.phase??"running")}`})]}),p("td",{title:M.text,children:M.text!==""&&p(hn,{tone:M.tone,children:M.text})}),p("td",{class:"numeric",children:_.surface_distance?Mi(_.surface_distance.mean_mm):""}),p("td",{children:p(Qx,{id:_.id,state:_.state})}),p("td",{children:_.method}),p("td",{children:_s(_.created_at,l)}),p("td",{children:_.started_at?Bi((_.finished_at?Date.parse(_.finished_at):l)-Date.parse(_.started_at)):""}),p("td",{children:_.state==="queued"?p(Wa,{class:"priority",type:"number",min:-100,max:100,value:String(_.priority),"aria-label":`Priority of job ${Qn(_.id)}, −100 to 100, higher first`,take:S=>{f(_.id,Number(S))}}):_.priority}),p("td",{children:Kn(_.state)?p("button",{"aria-label":`Retry job ${Qn(_.id)}`,onClick:()=>h("retry",_.id),children:"Retry"}):p("button",{"aria-label":`Cancel job ${Qn(_.id)}`,disabled:_.cancel_requested,onClick:()=>h("cancel",_.id),children:"Cancel"})})]},_.id)}),g>0&&p("tr",{"aria-hidden":"true",style:{height:`${g}px`}})]})]})})}var fC=6e4,$h=n=>{let{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,study_id:d,external_ref:y,cancel_requested:v,tags:g}=n,x=d?"target":"source",_=n.method!=="study_score"&&(n[x]?.n_faces??1/0)<=fC?x:null;return{id:e,state:t,method:i,priority:s,progress:r,created_at:o,started_at:a,finished_at:l,reliable:c,unreliable_reasons:u,surface_distance:h,batch_id:f,study_id:d,external_ref:y,cancel_requested:v,tags:g,pictured:_}},[ty,dC]=[100,500],[pC,$p]=[300,2e3],Xp=20;function ny({query:n}){let e=Object.fromEntries(Mc.map(m=>[m,n.get(m)??""])),t=JSON.stringify(e),[i,s]=ae([]),[r,o]=ae(""),[a,l]=ae(null),[c,u]=ae(!0),[h,f]=ae([]),[d,y]=ae(!1),v=m=>l(Et(m)),g=wt(new Map);g.current=Qt(()=>new Map(i.map(m=>[m.id,m])),[i]);let x=wt(null),[_,M]=dr("pictures","yes");Vt(m=>{s([]),o(""),y(!1);let w=new Set,R=async(te,j)=>{let he=new Set;w.add(he);try{let me=await te();m.aborted||j(me,he)}finally{w.delete(he)}},C=(te,j,he)=>R(()=>vt(`v1/jobs${Si({...e,page_size:te,page_token:j})}`,m),(me,Q)=>{he(me,me.jobs.map($h),Q),q(me.jobs.map(({id:ue})=>ue).filter(ue=>Q.has(ue)))}),I=()=>C(ty,"",(te,j)=>{s(he=>{let me=new Map(he.map(Q=>[Q.id,Q]));return j.map(Q=>lo(me.get(Q.id),Q))}),o(te.next_page_token),l(null)}),E=!1,F=async te=>{if(!E){E=!0;try{await C(dC,te,(j,he)=>{s(me=>[...me,...he]),o(j.next_page_token),l(null)})}catch(j){m.aborted||v(j)}finally{E=!1}}},D=async()=>{let te=new Set;return e.order==="asc"||await C(ty,"",(j,he,me)=>{te=new Set(he.map(Q=>Q.id)),s(Q=>{let ue=new Map(Q.map(Me=>[Me.id,Me]));return[...he.map(Me=>me.has(Me.id)&&ue.get(Me.id)||lo(ue.get(Me.id),Me)),...Q.filter(Me=>!te.has(Me.id))]})}),te},z=te=>e.state===""||e.state.split(",").includes(te.state),X=async te=>{for(let j=0;j<te.length&&!m.aborted;j+=Xp){let he=[],me=Q=>vt(`v1/jobs/${Q}`,m).then($h,ue=>(xa(ue)||he.push(Q),null));await R(()=>Promise.all(te.slice(j,j+Xp).map(me)),(Q,ue)=>{let Me=new Map(Q.flatMap(We=>We===null||ue.has(We.id)?[]:[[We.id,We]]));s(We=>We.map(Ge=>lo(Ge,Me.get(Ge.id)??Ge)).filter(z))}),q(he,$p)}},k=new Set,se=0,q=(te,j=pC)=>{te.forEach(he=>k.add(he)),k.size>0&&se===0&&!m.aborted&&(se=window.setTimeout(()=>{ne()},j))},J=!1,ne=async()=>{se=0;let te=[...k];k.clear();let j=te.filter(me=>g.current.has(me)),he=j.length>Xp;if(he&&J)return q(te,$p);J||=he;try{let me=he||j.length<te.length?await D():new Set;await X(j.filter(Q=>!me.has(Q)))}catch(me){xa(me)||q(te,$p)}finally{he&&(J=!1)}};x.current={more:F,renew:X};let pe=I().catch(te=>{m.aborted||v(te)});Xx(async()=>{await pe;try{await I(),y(!0)}catch(te){if(!xa(te))throw te;v(te)}},te=>{let j=te.map(({job_id:he})=>he);for(let he of w)j.forEach(me=>he.add(me));q(j)},u,m),(async()=>{for(;!m.aborted;){await Jn(2e3,m);let te=[...g.current.values()].filter(j=>j.state==="running").slice(0,16);te.length>0&&!document.hidden&&await X(te.map(j=>j.id))}})()},[t]),ct(()=>{vt("v1/methods").then(({methods:m})=>f(m.map(({name:w})=>w)),()=>{})},[]);let S=(m,w)=>Ti("jobs",{...e,[m]:w},!0),T=()=>{let{order:m,...w}=e,R=Object.values(w).some(C=>C!=="");confirm(R?"Cancel all queued and running jobs that these filters select?":"Cancel all queued and running jobs?")&&Vn("POST",`v1/jobs/cancel${Si({...w,all:R?void 0:"true"})}`).catch(v)},b=Mc.some(m=>e[m]!=="");return p("div",{class:"jobs",children:[p("h1",{children:["Jobs ",!c&&p(hn,{tone:"bad",children:"connection lost, trying again"})]}),p("form",{class:"tools",role:"search","aria-label":"Filters",onSubmit:m=>m.preventDefault(),children:[p("label",{children:["State"," ",p("select",{value:e.state,onChange:m=>S("state",m.currentTarget.value),children:[p("option",{value:"",children:"any"}),xc.map(m=>p("option",{value:m,children:m}))]})]}),p("label",{children:["Method"," ",p("select",{value:e.method,onChange:m=>S("method",m.currentTarget.value),children:[p("option",{value:"",children:"any"}),h.map(m=>p("option",{value:m,children:m}))]})]}),p("label",{children:["Tag ",p(Wa,{value:e.tag,placeholder:"name:value",take:m=>S("tag",m)})]}),p("label",{children:["Reference ",p(Wa,{value:e.external_ref,take:m=>S("external_ref",m)})]}),p("label",{children:["Order"," ",p("select",{value:e.order,onChange:m=>S("order",m.currentTarget.value),children:[p("option",{value:"",children:"newest first"}),p("option",{value:"asc",children:"oldest first"})]})]}),b&&p("button",{type:"button",onClick:()=>Ti("jobs",{},!0),children:"Clear filters"}),p("button",{type:"button",onClick:T,children:"Cancel these …"}),p(qn,{label:"Pictures",checked:_==="yes",onChange:m=>M(m.currentTarget.checked?"yes":"no")}),p(kg,{filters:e,isFiltered:b})]}),p(At,{text:a}),p(ey,{rows:i,pictures:_==="yes",hasMore:r!==void 0,more:d&&r?()=>{x.current?.more(r)}:null,renew:m=>{x.current?.renew(m)},failed:v}),i.length===0&&r===void 0&&p("p",{class:"empty",children:[b?"No job fits these filters.":"There is no job yet."," ",p("a",{href:"#/submit",children:"Submit a pair of surfaces"}),", or the two built-in phantoms."]})]})}var mC="uplot",gC="u-hz",_C="u-vt",xC="u-title",yC="u-wrap",vC="u-under",bC="u-over",SC="u-axis",ho="u-off",MC="u-select",wC="u-cursor-x",TC="u-cursor-y",AC="u-cursor-pt",EC="u-legend",CC="u-live",RC="u-inline",PC="u-series",IC="u-marker",iy="u-label",LC="u-value",Xl="width",ql="height";var sy="bottom",ba="left",qp="right",um="#000",ry=um+"0",Yp="mousemove",oy="mousedown",jp="mouseup",ay="mouseenter",ly="mouseleave",cy="dblclick",NC="resize",DC="scroll",uy="change",Jh="dppxchange",hm="--",Ca=typeof window<"u",em=Ca?document:null,Ma=Ca?window:null,FC=Ca?navigator:null,Nt,Xh;function tm(){let n=devicePixelRatio;Nt!=n&&(Nt=n,Xh&&im(uy,Xh,tm),Xh=matchMedia(`(min-resolution: ${Nt-.001}dppx) and (max-resolution: ${Nt+.001}dppx)`),fo(uy,Xh,tm),Ma.dispatchEvent(new CustomEvent(Jh)))}function Ni(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function nm(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function tn(n,e,t){n.style[e]=t+"px"}function os(n,e,t,i){let s=em.createElement(n);return e!=null&&Ni(s,e),t?.insertBefore(s,i),s}function Wi(n,e){return os("div",n,e)}var hy=new WeakMap;function Rs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=hy.get(n);r!=o&&(n.style.transform=r,hy.set(n,r),e<0||t<0||e>i||t>s?Ni(n,ho):nm(n,ho))}var fy=new WeakMap;function dy(n,e,t){let i=e+t,s=fy.get(n);i!=s&&(fy.set(n,i),n.style.background=e,n.style.borderColor=t)}var py=new WeakMap;function my(n,e,t,i){let s=e+""+t,r=py.get(n);s!=r&&(py.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var fm={passive:!0},OC={...fm,capture:!0};function fo(n,e,t,i){e.addEventListener(n,t,i?OC:fm)}function im(n,e,t,i){e.removeEventListener(n,t,fm)}Ca&&tm();function as(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Di((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Hy(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Wy=n=>n!=null,$y=n=>n!=null&&n>0,Qh=Hy(Wy),UC=Hy($y);function BC(n,e,t,i=0,s=!1){let r=s?UC:Qh,o=s?$y:Wy;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Xt,l??-Xt]}function ef(n,e,t,i){let s=xy(n),r=xy(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?ir:Xy,a=s==1?Di:$i,l=r==1?$i:Di,c=a(o(Dn(n))),u=l(o(Dn(e))),h=wa(t,c),f=wa(t,u);return t==10&&(c<0&&(h=qt(h,-c)),u<0&&(f=qt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=Jy(n,h),e=tf(e,f)),[n,e]}function dm(n,e,t,i){let s=ef(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var pm=.1,gy={mode:3,pad:pm},jl={pad:0,soft:null,mode:0},kC={min:jl,max:jl};function Zh(n,e,t,i){return nf(t)?_y(n,e,t):(jl.pad=t,jl.soft=i?0:null,jl.mode=i?3:0,_y(n,e,kC))}function Rt(n,e){return n??e}function zC(n,e,t){for(e=Rt(e,0),t=Rt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function _y(n,e,t){let i=t.min,s=t.max,r=Rt(i.pad,0),o=Rt(s.pad,0),a=Rt(i.hard,-Xt),l=Rt(s.hard,Xt),c=Rt(i.soft,Xt),u=Rt(s.soft,-Xt),h=Rt(i.mode,0),f=Rt(s.mode,0),d=e-n,y=ir(d),v=di(Dn(n),Dn(e)),g=ir(v),x=Dn(g-y);(d<1e-24||x>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Xt&&(r=0),f==2&&u!=-Xt&&(o=0)));let _=d||v||1e3,M=ir(_),S=wa(10,Di(M)),T=_*(d==0?n==0?.1:1:r),b=qt(Jy(n-T,S/10),24),m=n>=c&&(h==1||h==3&&b<=c||h==2&&b>=c)?c:Xt,w=di(a,b<m&&n>=m?m:ls(m,b)),R=_*(d==0?e==0?.1:1:o),C=qt(tf(e+R,S/10),24),I=e<=u&&(f==1||f==3&&C>=u||f==2&&C<=u)?u:-Xt,E=ls(l,C>I&&e<=I?I:di(I,C));return w==E&&w==0&&(E=100),[w,E]}var VC=new Intl.NumberFormat(Ca?FC.language:"en-US"),mm=n=>VC.format(n),Fi=Math,jh=Fi.PI,Dn=Fi.abs,Di=Fi.floor,Nn=Fi.round,$i=Fi.ceil,ls=Fi.min,di=Fi.max,wa=Fi.pow,xy=Fi.sign,ir=Fi.log10,Xy=Fi.log2,GC=(n,e=1)=>Fi.sinh(n)*e,Jp=(n,e=1)=>Fi.asinh(n/e),Xt=1/0;function yy(n){return(ir((n^n>>31)-(n>>31))|0)+1}function sm(n,e,t){return ls(di(n,e),t)}function qy(n){return typeof n=="function"}function Mt(n){return qy(n)?n:()=>n}var HC=()=>{},Yy=n=>n,jy=(n,e)=>e,WC=n=>null,vy=n=>!0,by=(n,e)=>n==e,$C=/\.\d*?(?=9{6,}|0{6,})/gm,po=n=>{if(Ky(n)||Nr.has(n))return n;let e=`${n}`,t=e.match($C);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${po(s)}e${r}`}return qt(n,i)};function co(n,e){return po(qt(po(n/e))*e)}function tf(n,e){return po($i(po(n/e))*e)}function Jy(n,e){return po(Di(po(n/e))*e)}function qt(n,e=0){if(Ky(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Nn(i)/t}var Nr=new Map;function Zy(n){return((""+n).split(".")[1]||"").length}function Zl(n,e,t,i){let s=[],r=i.map(Zy);for(let o=e;o<t;o++){let a=Dn(o),l=qt(wa(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:qt(u,h);s.push(f),Nr.set(f,h)}}return s}var Jl={},gm=[],Ta=[null,null],Lr=Array.isArray,Ky=Number.isInteger,XC=n=>n===void 0;function Sy(n){return typeof n=="string"}function nf(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function qC(n){return n!=null&&typeof n=="object"}var YC=Object.getPrototypeOf(Uint8Array),Qy="__proto__";function Aa(n,e=nf){let t;if(Lr(n)){let i=n.find(s=>s!=null);if(Lr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Aa(n[s],e)}else t=n.slice()}else if(n instanceof YC)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Qy&&(t[i]=Aa(n[i],e))}else t=n;return t}function An(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Qy&&(nf(n[s])?An(n[s],Aa(i[s])):n[s]=Aa(i[s]))}return n}var jC=0,JC=1,ZC=2;function KC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function QC(n,e){if(nR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return iR(o[0])||(o=tR(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:JC,d=[];for(let y=0;y<u.length;y++){let v=u[y],g=r.get(l[y]);v===null?f!=jC&&(h[g]=v,f==ZC&&d.push(g)):h[g]=v}KC(h,d,s),i.push(h)}}return i}var eR=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function tR(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function nR(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function iR(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=di(1,Di((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ev=["January","February","March","April","May","June","July","August","September","October","November","December"],tv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function nv(n){return n.slice(0,3)}var sR=tv.map(nv),rR=ev.map(nv),oR={MMMM:ev,MMM:rR,WWWW:tv,WWW:sR};function $l(n){return(n<10?"0":"")+n}function aR(n){return(n<10?"00":n<100?"0":"")+n}var lR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>$l(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$l(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>$l(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$l(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$l(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>aR(n.getMilliseconds())};function _m(n,e){e=e||oR;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?lR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var cR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function uR(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==cR?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var iv=n=>n%1==0,Kh=[1,2,2.5,5],hR=Zl(10,-32,0,Kh),sv=Zl(10,0,32,Kh),fR=sv.filter(iv),uo=hR.concat(sv),xm=`
`,rv="{YYYY}",My=xm+rv,ov="{M}/{D}",Yl=xm+ov,qh=Yl+"/{YY}",av="{aa}",dR="{h}:{mm}",Sa=dR+av,wy=xm+Sa,Ty=":{ss}",Ot=null;function lv(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Zl(10,0,3,Kh).filter(iv):Zl(10,-3,0,Kh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,rv,Ot,Ot,Ot,Ot,Ot,Ot,1],[s*28,"{MMM}",My,Ot,Ot,Ot,Ot,Ot,1],[s,ov,My,Ot,Ot,Ot,Ot,Ot,1],[i,"{h}"+av,qh,Ot,Yl,Ot,Ot,Ot,1],[t,Sa,qh,Ot,Yl,Ot,Ot,Ot,1],[e,Ty,qh+" "+Sa,Ot,Yl+" "+Sa,Ot,wy,Ot,1],[n,Ty+".{fff}",qh+" "+Sa,Ot,Yl+" "+Sa,Ot,wy,Ot,1]];function u(h){return(f,d,y,v,g,x)=>{let _=[],M=g>=o,S=g>=r&&g<o,T=h(y),b=qt(T*n,3),m=Zp(T.getFullYear(),M?0:T.getMonth(),S||M?1:T.getDate()),w=qt(m*n,3);if(S||M){let R=S?g/r:0,C=M?g/o:0,I=b==w?b:qt(Zp(m.getFullYear()+C,m.getMonth()+R,1)*n,3),E=new Date(Nn(I/n)),F=E.getFullYear(),D=E.getMonth();for(let z=0;I<=v;z++){let X=Zp(F+C*z,D+R*z,1),k=X-h(qt(X*n,3));I=qt((+X+k)*n,3),I<=v&&_.push(I)}}else{let R=g>=s?s:g,C=Di(y)-Di(b),I=w+C+tf(b-w,R);_.push(I);let E=h(I),F=E.getHours()+E.getMinutes()/t+E.getSeconds()/i,D=g/i,z=f.axes[d]._space,X=x/z;for(;I=qt(I+g,n==1?0:3),!(I>v);)if(D>1){let k=Di(qt(F+D,6))%24,J=h(I).getHours()-k;J>1&&(J=-1),I-=J*i,F=(F+D)%24;let ne=_[_.length-1];qt((I-ne)/g,3)*X>=.7&&_.push(I)}else _.push(I)}return _}}return[l,c,u]}var[pR,mR,gR]=lv(1),[_R,xR,yR]=lv(.001);Zl(2,-53,53,[1]);function Ay(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Ey(n,e){return(t,i,s,r,o)=>{let a=e.find(y=>o>=y[0])||e[e.length-1],l,c,u,h,f,d;return i.map(y=>{let v=n(y),g=v.getFullYear(),x=v.getMonth(),_=v.getDate(),M=v.getHours(),S=v.getMinutes(),T=v.getSeconds(),b=g!=l&&a[2]||x!=c&&a[3]||_!=u&&a[4]||M!=h&&a[5]||S!=f&&a[6]||T!=d&&a[7]||a[1];return l=g,c=x,u=_,h=M,f=S,d=T,b(v)})}}function vR(n,e){let t=_m(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Zp(n,e,t){return new Date(n,e,t)}function Cy(n,e){return e(n)}var bR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ry(n,e){return(t,i,s,r)=>r==null?hm:e(n(i))}function SR(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function MR(n,e){return n.series[e].fill(n,e)}var wR={show:!0,live:!0,isolate:!1,mount:HC,markers:{show:!0,width:2,stroke:SR,fill:MR,dash:"solid"},idx:null,idxs:null,values:[]};function TR(n,e){let t=n.cursor.points,i=Wi(),s=t.size(n,e);tn(i,Xl,s),tn(i,ql,s);let r=s/-2;tn(i,"marginLeft",r),tn(i,"marginTop",r);let o=t.width(n,e,s);return o&&tn(i,"borderWidth",o),i}function AR(n,e){let t=n.series[e].points;return t._fill||t._stroke}function ER(n,e){let t=n.series[e].points;return t._stroke||t._fill}function CR(n,e){return n.series[e].points.size}var Kp=[0,0];function RR(n,e,t){return Kp[0]=e,Kp[1]=t,Kp}function Yh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Qp(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var PR={show:!0,x:!0,y:!0,lock:!1,move:RR,points:{one:!1,show:TR,size:CR,width:0,stroke:ER,fill:AR},bind:{mousedown:Yh,mouseup:Yh,click:Yh,dblclick:Yh,mousemove:Qp,mouseleave:Qp,mouseenter:Qp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},cv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ym=An({},cv,{filter:jy}),uv=An({},ym,{size:10}),hv=An({},cv,{show:!1}),vm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fv="bold "+vm,dv=1.5,Py={show:!0,scale:"x",stroke:um,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fv,side:2,grid:ym,ticks:uv,border:hv,font:vm,lineGap:dv,rotate:0},IR="Value",LR="Time",Iy={show:!0,scale:"x",auto:!1,sorted:1,min:Xt,max:-Xt,idxs:[]};function NR(n,e,t,i,s){return e.map(r=>r==null?"":mm(r))}function DR(n,e,t,i,s,r,o){let a=[],l=Nr.get(s)||0;t=o?t:qt(tf(t,s),l);for(let c=t;c<=i;c=qt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function rm(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?ir:Xy,u=Di(c(t));s=wa(l,u),l==10&&(s=uo[as(s,uo)]);let h=t,f=s*l;l==10&&(f=uo[as(f,uo)]);do a.push(h),h=h+s,l==10&&!Nr.has(h)&&(h=qt(h,Nr.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=uo[as(f,uo)]));while(h<=i);return a}function FR(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?rm(n,e,di(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?rm(n,e,di(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var pv=/./,OR=/[12357]/,UR=/[125]/,Ly=/1/,om=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function BR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?pv:l(7,o)-u>=c?OR:l(5,o)-u>=c?UR:Ly;if(h==Ly){let f=Dn(l(1,o)-u);if(f<c)return om(e.slice().reverse(),a.distr,h,$i(c/f)).reverse()}return om(e,a.distr,h,1)}function kR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Dn(l(1,o)-l(2,o));return c<a?om(e.slice().reverse(),3,pv,$i(a/c)).reverse():e}function zR(n,e,t,i){return i==null?hm:e==null?"":mm(e)}var Ny={show:!0,scale:"y",stroke:um,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fv,side:3,grid:ym,ticks:uv,border:hv,font:vm,lineGap:dv,rotate:0};function VR(n,e){let t=3+(n||1)*2;return qt(t*e,3)}function GR(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Dn(o-r),l=n.series[e],c=a/(l.points.space*Nt);return i[1]-i[0]<=c}var Dy={scale:null,auto:!0,sorted:0,min:Xt,max:-Xt},mv=(n,e,t,i,s)=>s,Fy={show:!0,auto:!0,sorted:0,gaps:mv,alpha:1,facets:[An({},Dy,{scale:"x"}),An({},Dy,{scale:"y"})]},Oy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:mv,alpha:1,points:{show:GR,filter:null},values:null,min:Xt,max:-Xt,idxs:[],path:null,clip:null};function HR(n,e,t,i,s){return t/10}var gv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},WR=An({},gv,{time:!1,ori:1}),Uy={};function _v(n,e){let t=Uy[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Uy[n]=t)),t}var Ea=1,am=2;function mo(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,y=a.width,v=a.height,g=n.valToPosH,x=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,x,f,d,y,v,rf,Ra,af,yv,bv):t(s,l,c,u,h,x,g,d,f,v,y,of,Pa,Mm,vv,Sv)}function bm(n,e){let t=0,i=0,s=Rt(n.bands,gm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function $R(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function sr(n,e,t,i,s,r){return mo(n,e,(o,a,l,c,u,h,f,d,y,v,g)=>{let x=o.pxRound,_=c.dir*(c.ori==0?1:-1),M=c.ori==0?Ra:Pa,S,T;_==1?(S=t,T=i):(S=i,T=t);let b=x(h(a[S],c,v,d)),m=x(f(l[S],u,g,y)),w=x(h(a[T],c,v,d)),R=x(f(r==1?u.max:u.min,u,g,y)),C=new Path2D(s);return M(C,w,R),M(C,b,R),M(C,b,m),C})}function sf(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?af:Mm,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function XR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Sm(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),y=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let x=f+s;y=o>=0&&x>=0&&x<l?r(n[x]):y,y>=d&&a.push([d,y])}return a}function By(n){return n==0?Yy:n==1?Nn:e=>co(e,n)}function xv(n){let e=n==0?rf:of,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ls(c,a/2,l/2),u=ls(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var rf=(n,e,t)=>{n.moveTo(e,t)},of=(n,e,t)=>{n.moveTo(t,e)},Ra=(n,e,t)=>{n.lineTo(e,t)},Pa=(n,e,t)=>{n.lineTo(t,e)},af=xv(0),Mm=xv(1),yv=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},vv=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},bv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Sv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Mv(n){return(e,t,i,s,r)=>mo(e,t,(o,a,l,c,u,h,f,d,y,v,g)=>{let{pxRound:x,points:_}=o,M,S;c.ori==0?(M=rf,S=yv):(M=of,S=vv);let T=qt(_.width*Nt,3),b=(_.size-_.width)/2*Nt,m=qt(b*2,3),w=new Path2D,R=new Path2D,{left:C,top:I,width:E,height:F}=e.bbox;af(R,C-m,I-m,E+m*2,F+m*2);let D=z=>{if(l[z]!=null){let X=x(h(a[z],c,v,d)),k=x(f(l[z],u,g,y));M(w,X+b,k),S(w,X,k,b,0,jh*2)}};if(r)r.forEach(D);else for(let z=i;z<=s;z++)D(z);return{stroke:T>0?w:null,fill:w,clip:R,flags:Ea|am}})}function wv(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var qR=wv(Ra),YR=wv(Pa);function Tv(n){let e=Rt(n?.alignGaps,0);return(t,i,s,r)=>mo(t,i,(o,a,l,c,u,h,f,d,y,v,g)=>{[s,r]=Qh(l,s,r);let x=o.pxRound,_=F=>x(h(F,c,v,d)),M=F=>x(f(F,u,g,y)),S,T;c.ori==0?(S=Ra,T=qR):(S=Pa,T=YR);let b=c.dir*(c.ori==0?1:-1),m={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ea},w=m.stroke,R=!1;if(r-s>=v*4){let F=te=>t.posToVal(te,c.key,!0),D=null,z=null,X,k,se,q=_(a[b==1?s:r]),J=_(a[s]),ne=_(a[r]),pe=F(b==1?J+1:ne-1);for(let te=b==1?s:r;te>=s&&te<=r;te+=b){let j=a[te],me=(b==1?j<pe:j>pe)?q:_(j),Q=l[te];me==q?Q!=null?(k=Q,D==null?(S(w,me,M(k)),X=D=z=k):k<D?D=k:k>z&&(z=k)):Q===null&&(R=!0):(D!=null&&T(w,q,M(D),M(z),M(X),M(k)),Q!=null?(k=Q,S(w,me,M(k)),D=z=X=k):(D=z=null,Q===null&&(R=!0)),q=me,pe=F(q+b))}D!=null&&D!=z&&se!=q&&T(w,q,M(D),M(z),M(X),M(k))}else for(let F=b==1?s:r;F>=s&&F<=r;F+=b){let D=l[F];D===null?R=!0:D!=null&&S(w,_(a[F]),M(D))}let[I,E]=bm(t,i);if(o.fill!=null||I!=0){let F=m.fill=new Path2D(w),D=o.fillTo(t,i,o.min,o.max,I),z=M(D),X=_(a[s]),k=_(a[r]);b==-1&&([k,X]=[X,k]),S(F,k,z),S(F,X,z)}if(!o.spanGaps){let F=[];R&&F.push(...Sm(a,l,s,r,b,_,e)),m.gaps=F=o.gaps(t,i,s,r,F),m.clip=sf(F,c.ori,d,y,v,g)}return E!=0&&(m.band=E==2?[sr(t,i,s,r,w,-1),sr(t,i,s,r,w,1)]:sr(t,i,s,r,w,E)),m})}function jR(n){let e=Rt(n.align,1),t=Rt(n.ascDesc,!1),i=Rt(n.alignGaps,0),s=Rt(n.extend,!1);return(r,o,a,l)=>mo(r,o,(c,u,h,f,d,y,v,g,x,_,M)=>{[a,l]=Qh(h,a,l);let S=c.pxRound,{left:T,width:b}=r.bbox,m=J=>S(y(J,f,_,g)),w=J=>S(v(J,d,M,x)),R=f.ori==0?Ra:Pa,C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ea},I=C.stroke,E=f.dir*(f.ori==0?1:-1),F=w(h[E==1?a:l]),D=m(u[E==1?a:l]),z=D,X=D;s&&e==-1&&(X=T,R(I,X,F)),R(I,D,F);for(let J=E==1?a:l;J>=a&&J<=l;J+=E){let ne=h[J];if(ne==null)continue;let pe=m(u[J]),te=w(ne);e==1?R(I,pe,F):R(I,z,te),R(I,pe,te),F=te,z=pe}let k=z;s&&e==1&&(k=T+b,R(I,k,F));let[se,q]=bm(r,o);if(c.fill!=null||se!=0){let J=C.fill=new Path2D(I),ne=c.fillTo(r,o,c.min,c.max,se),pe=w(ne);R(J,k,pe),R(J,X,pe)}if(!c.spanGaps){let J=[];J.push(...Sm(u,h,a,l,E,m,i));let ne=c.width*Nt/2,pe=t||e==1?ne:-ne,te=t||e==-1?-ne:ne;J.forEach(j=>{j[0]+=pe,j[1]+=te}),C.gaps=J=c.gaps(r,o,a,l,J),C.clip=sf(J,f.ori,g,x,_,M)}return q!=0&&(C.band=q==2?[sr(r,o,a,l,I,-1),sr(r,o,a,l,I,1)]:sr(r,o,a,l,I,q)),C})}function ky(n,e,t,i,s,r,o=Xt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Dn(n[l]-n[a]);u<c&&(c=u,o=Dn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function JR(n){n=n||Jl;let e=Rt(n.size,[.6,Xt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),o=1-e[0],a=Rt(e[1],Xt),l=Rt(e[2],1),c=Rt(n.disp,Jl),u=Rt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,y,v,g)=>mo(d,y,(x,_,M,S,T,b,m,w,R,C,I)=>{let E=x.pxRound,F=t,D=i*Nt,z=a*Nt,X=l*Nt,k,se;S.ori==0?[k,se]=r(d,y):[se,k]=r(d,y);let q=S.dir*(S.ori==0?1:-1),J=S.ori==0?af:Mm,ne=S.ori==0?u:(Le,Ze,lt,Ee,$t,$e,Ye)=>{u(Le,Ze,lt,$t,Ee,Ye,$e)},pe=Rt(d.bands,gm).find(Le=>Le.series[0]==y),te=pe!=null?pe.dir:0,j=x.fillTo(d,y,x.min,x.max,te),he=E(m(j,T,I,R)),me,Q,ue,Me=C,We=E(x.width*Nt),Ge=!1,pt=null,ht=null,ot=null,nn=null;h!=null&&(We==0||f!=null)&&(Ge=!0,pt=h.values(d,y,v,g),ht=new Map,new Set(pt).forEach(Le=>{Le!=null&&ht.set(Le,new Path2D)}),We>0&&(ot=f.values(d,y,v,g),nn=new Map,new Set(ot).forEach(Le=>{Le!=null&&nn.set(Le,new Path2D)})));let{x0:Yt,size:gn}=c;if(Yt!=null&&gn!=null){F=1,_=Yt.values(d,y,v,g),Yt.unit==2&&(_=_.map(lt=>d.posToVal(w+lt*C,S.key,!0)));let Le=gn.values(d,y,v,g);gn.unit==2?Q=Le[0]*C:Q=b(Le[0],S,C,w)-b(0,S,C,w),Me=ky(_,M,b,S,C,w,Me),ue=Me-Q+D}else Me=ky(_,M,b,S,C,w,Me),ue=Me*o+D,Q=Me-ue;ue<1&&(ue=0),We>=Q/2&&(We=0),ue<5&&(E=Yy);let Gt=ue>0,Fn=Me-ue-(Gt?We:0);Q=E(sm(Fn,X,z)),me=(F==0?Q/2:F==q?0:Q)-F*q*((F==0?D/2:0)+(Gt?We/2:0));let Tt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},En=Ge?null:new Path2D,on=null;if(pe!=null)on=d.data[pe.series[1]];else{let{y0:Le,y1:Ze}=c;Le!=null&&Ze!=null&&(M=Ze.values(d,y,v,g),on=Le.values(d,y,v,g))}let _n=k*Q,G=se*Q;for(let Le=q==1?v:g;Le>=v&&Le<=g;Le+=q){let Ze=M[Le];if(Ze==null)continue;if(on!=null){let Y=on[Le]??0;if(Ze-Y==0)continue;he=m(Y,T,I,R)}let lt=S.distr!=2||c!=null?_[Le]:Le,Ee=b(lt,S,C,w),$t=m(Rt(Ze,j),T,I,R),$e=E(Ee-me),Ye=E(di($t,he)),O=E(ls($t,he)),P=Ye-O;if(Ze!=null){let Y=Ze<0?G:_n,xe=Ze<0?_n:G;Ge?(We>0&&ot[Le]!=null&&J(nn.get(ot[Le]),$e,O+Di(We/2),Q,di(0,P-We),Y,xe),pt[Le]!=null&&J(ht.get(pt[Le]),$e,O+Di(We/2),Q,di(0,P-We),Y,xe)):J(En,$e,O+Di(We/2),Q,di(0,P-We),Y,xe),ne(d,y,Le,$e-We/2,O,Q+We,P)}}return We>0?Tt.stroke=Ge?nn:En:Ge||(Tt._fill=x.width==0?x._fill:x._stroke??x._fill,Tt.width=0),Tt.fill=Ge?ht:En,Tt})}function ZR(n,e){let t=Rt(e?.alignGaps,0);return(i,s,r,o)=>mo(i,s,(a,l,c,u,h,f,d,y,v,g,x)=>{[r,o]=Qh(c,r,o);let _=a.pxRound,M=k=>_(f(k,u,g,y)),S=k=>_(d(k,h,x,v)),T,b,m;u.ori==0?(T=rf,m=Ra,b=bv):(T=of,m=Pa,b=Sv);let w=u.dir*(u.ori==0?1:-1),R=M(l[w==1?r:o]),C=R,I=[],E=[];for(let k=w==1?r:o;k>=r&&k<=o;k+=w)if(c[k]!=null){let q=l[k],J=M(q);I.push(C=J),E.push(S(c[k]))}let F={stroke:n(I,E,T,m,b,_),fill:null,clip:null,band:null,gaps:null,flags:Ea},D=F.stroke,[z,X]=bm(i,s);if(a.fill!=null||z!=0){let k=F.fill=new Path2D(D),se=a.fillTo(i,s,a.min,a.max,z),q=S(se);m(k,C,q),m(k,R,q)}if(!a.spanGaps){let k=[];k.push(...Sm(l,c,r,o,w,M,t)),F.gaps=k=a.gaps(i,s,r,o,k),F.clip=sf(k,u.ori,y,v,g,x)}return X!=0&&(F.band=X==2?[sr(i,s,r,o,D,-1),sr(i,s,r,o,D,1)]:sr(i,s,r,o,D,X)),F})}function KR(n){return ZR(QR,n)}function QR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var lm=new Set;function zy(){for(let n of lm)n.syncRect(!0)}Ca&&(fo(NC,Ma,zy),fo(DC,Ma,zy,!0),fo(Jh,Ma,()=>{$n.pxRatio=Nt}));var e2=Tv(),t2=Mv();function Vy(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>cm(r,o,e,t))}function n2(n,e){return n.map((t,i)=>i==0?{}:An({},e,t))}function cm(n,e,t,i){return An({},e==0?t:i,n)}function Av(n,e,t){return e==null?Ta:[e,t]}var i2=Av;function s2(n,e,t){return e==null?Ta:Zh(e,t,pm,!0)}function Ev(n,e,t,i){return e==null?Ta:ef(e,t,n.scales[i].log,!1)}var r2=Ev;function Cv(n,e,t,i){return e==null?Ta:dm(e,t,n.scales[i].log,!1)}var o2=Cv;function a2(n,e,t,i,s){let r=di(yy(n),yy(e)),o=e-n,a=as(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Nr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Gy(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Nn((t=+s)*Nt))+"px"),[n,e,t]}function l2(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=qt(e[2]*Nt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function $n(n,e,t){let i={mode:Rt(n.mode,1)},s=i.mode;function r(A,L,U,B){let $=L.valToPct(A);return B+U*(L.dir==-1?1-$:$)}function o(A,L,U,B){let $=L.valToPct(A);return B+U*(L.dir==-1?$:1-$)}function a(A,L,U,B){return L.ori==0?r(A,L,U,B):o(A,L,U,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Wi(mC);if(n.id!=null&&(c.id=n.id),Ni(c,n.class),n.title){let A=Wi(xC,c);A.textContent=n.title}let u=os("canvas"),h=i.ctx=u.getContext("2d"),f=Wi(yC,c);fo("click",f,A=>{A.target===y&&(Jt!=wo||sn!=To)&&Xn.click(i,A)},!0);let d=i.under=Wi(vC,f);f.appendChild(u);let y=i.over=Wi(bC,f);n=Aa(n);let v=+Rt(n.pxAlign,1),g=By(v);(n.plugins||[]).forEach(A=>{A.opts&&(n=A.opts(i,n)||n)});let x=n.ms||.001,_=i.series=s==1?Vy(n.series||[],Iy,Oy,!1):n2(n.series||[null],Fy),M=i.axes=Vy(n.axes||[],Py,Ny,!0),S=i.scales={},T=i.bands=n.bands||[];T.forEach(A=>{A.fill=Mt(A.fill||null),A.dir=Rt(A.dir,-1)});let b=s==2?_[1].facets[0].scale:_[0].scale,m={axes:Ns,series:_t},w=(n.drawOrder||["axes","series"]).map(A=>m[A]);function R(A){let L=A.distr==3?U=>ir(U>0?U:A.clamp(i,U,A.min,A.max,A.key)):A.distr==4?U=>Jp(U,A.asinh):A.distr==100?U=>A.fwd(U):U=>U;return U=>{let B=L(U),{_min:$,_max:ee}=A,de=ee-$;return(B-$)/de}}function C(A){let L=S[A];if(L==null){let U=(n.scales||Jl)[A]||Jl;if(U.from!=null){C(U.from);let B=An({},S[U.from],U,{key:A});B.valToPct=R(B),S[A]=B}else{L=S[A]=An({},A==b?gv:WR,U),L.key=A;let B=L.time,$=L.range,ee=Lr($);if((A!=b||s==2&&!B)&&(ee&&($[0]==null||$[1]==null)&&($={min:$[0]==null?gy:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?gy:{mode:1,hard:$[1],soft:$[1]}},ee=!1),!ee&&nf($))){let de=$;$=(ye,Te,Oe)=>Te==null?Ta:Zh(Te,Oe,de)}L.range=Mt($||(B?i2:A==b?L.distr==3?r2:L.distr==4?o2:Av:L.distr==3?Ev:L.distr==4?Cv:s2)),L.auto=Mt(ee?!1:L.auto),L.clamp=Mt(L.clamp||HR),L._min=L._max=null,L.valToPct=R(L)}}}C("x"),C("y"),s==1&&_.forEach(A=>{C(A.scale)}),M.forEach(A=>{C(A.scale)});for(let A in n.scales)C(A);let I=S[b],E=I.distr,F,D;I.ori==0?(Ni(c,gC),F=r,D=o):(Ni(c,_C),F=o,D=r);let z={};for(let A in S){let L=S[A];(L.min!=null||L.max!=null)&&(z[A]={min:L.min,max:L.max},L.min=L.max=null)}let X=n.tzDate||(A=>new Date(Nn(A/x))),k=n.fmtDate||_m,se=x==1?gR(X):yR(X),q=Ey(X,Ay(x==1?mR:xR,k)),J=Ry(X,Cy(bR,k)),ne=[],pe=i.legend=An({},wR,n.legend),te=i.cursor=An({},PR,{drag:{y:s==2}},n.cursor),j=pe.show,he=te.show,me=pe.markers;pe.idxs=ne,me.width=Mt(me.width),me.dash=Mt(me.dash),me.stroke=Mt(me.stroke),me.fill=Mt(me.fill);let Q,ue,Me,We=[],Ge=[],pt,ht=!1,ot={};if(pe.live){let A=_[1]?_[1].values:null;ht=A!=null,pt=ht?A(i,1,0):{_:0};for(let L in pt)ot[L]=hm}if(j)if(Q=os("table",EC,c),Me=os("tbody",null,Q),pe.mount(i,Q),ht){ue=os("thead",null,Q,Me);let A=os("tr",null,ue);os("th",null,A);for(var nn in pt)os("th",iy,A).textContent=nn}else Ni(Q,RC),pe.live&&Ni(Q,CC);let Yt={show:!0},gn={show:!1};function Gt(A,L){if(L==0&&(ht||!pe.live||s==2))return Ta;let U=[],B=os("tr",PC,Me,Me.childNodes[L]);Ni(B,A.class),A.show||Ni(B,ho);let $=os("th",null,B);if(me.show){let ye=Wi(IC,$);if(L>0){let Te=me.width(i,L);Te&&(ye.style.border=Te+"px "+me.dash(i,L)+" "+me.stroke(i,L)),ye.style.background=me.fill(i,L)}}let ee=Wi(iy,$);A.label instanceof HTMLElement?ee.appendChild(A.label):ee.textContent=A.label,L>0&&(me.show||(ee.style.color=A.width>0?me.stroke(i,L):me.fill(i,L)),Tt("click",$,ye=>{if(te._lock)return;et(ye);let Te=_.indexOf(A);if((ye.ctrlKey||ye.metaKey)!=pe.isolate){let Oe=_.some((Ue,ke)=>ke>0&&ke!=Te&&Ue.show);_.forEach((Ue,ke)=>{ke>0&&fs(ke,Oe?ke==Te?Yt:gn:Yt,!0,bn.setSeries)})}else fs(Te,{show:!A.show},!0,bn.setSeries)},!1),tt&&Tt(ay,$,ye=>{te._lock||(et(ye),fs(_.indexOf(A),Eo,!0,bn.setSeries))},!1));for(var de in pt){let ye=os("td",LC,B);ye.textContent="--",U.push(ye)}return[B,U]}let Fn=new Map;function Tt(A,L,U,B=!0){let $=Fn.get(L)||{},ee=te.bind[A](i,L,U,B);ee&&(fo(A,L,$[A]=ee),Fn.set(L,$))}function En(A,L,U){let B=Fn.get(L)||{};for(let $ in B)(A==null||$==A)&&(im($,L,B[$]),delete B[$]);A==null&&Fn.delete(L)}let on=0,_n=0,G=0,Le=0,Ze=0,lt=0,Ee=Ze,$t=lt,$e=G,Ye=Le,O=0,P=0,Y=0,xe=0;i.bbox={};let fe=!1,Se=!1,we=!1,re=!1,le=!1,ve=!1;function V(A,L,U){(U||A!=i.width||L!=i.height)&&ce(A,L),ft(!1),we=!0,Se=!0,Zn()}function ce(A,L){i.width=on=G=A,i.height=_n=Le=L,Ze=lt=0,Ae(),Xe();let U=i.bbox;O=U.left=co(Ze*Nt,.5),P=U.top=co(lt*Nt,.5),Y=U.width=co(G*Nt,.5),xe=U.height=co(Le*Nt,.5)}let oe=3;function Ce(){let A=!1,L=0;for(;!A;){L++;let U=bo(L),B=hs(L);A=L==oe||U&&B,A||(ce(i.width,i.height),Se=!0)}}function be({width:A,height:L}){V(A,L)}i.setSize=be;function Ae(){let A=!1,L=!1,U=!1,B=!1;M.forEach(($,ee)=>{if($.show&&$._show){let{side:de,_size:ye}=$,Te=de%2,Oe=$.label!=null?$.labelSize:0,Ue=ye+Oe;Ue>0&&(Te?(G-=Ue,de==3?(Ze+=Ue,B=!0):U=!0):(Le-=Ue,de==0?(lt+=Ue,A=!0):L=!0))}}),cs[0]=A,cs[1]=U,cs[2]=L,cs[3]=B,G-=Xi[1]+Xi[3],Ze+=Xi[3],Le-=Xi[2]+Xi[0],lt+=Xi[0]}function Xe(){let A=Ze+G,L=lt+Le,U=Ze,B=lt;function $(ee,de){switch(ee){case 1:return A+=de,A-de;case 2:return L+=de,L-de;case 3:return U-=de,U+de;case 0:return B-=de,B+de}}M.forEach((ee,de)=>{if(ee.show&&ee._show){let ye=ee.side;ee._pos=$(ye,ee._size),ee.label!=null&&(ee._lpos=$(ye,ee.labelSize))}})}if(te.dataIdx==null){let A=te.hover,L=A.skip=new Set(A.skip??[]);L.add(void 0);let U=A.prox=Mt(A.prox),B=A.bias??=0;te.dataIdx=($,ee,de,ye)=>{if(ee==0)return de;let Te=de,Oe=U($,ee,de,ye)??Xt,Ue=Oe>=0&&Oe<Xt,ke=I.ori==0?G:Le,at=te.left,Pt=e[0],Ct=e[ee];if(L.has(Ct[de])){Te=null;let xt=null,Ke=null,qe;if(B==0||B==-1)for(qe=de;xt==null&&qe-- >0;)L.has(Ct[qe])||(xt=qe);if(B==0||B==1)for(qe=de;Ke==null&&qe++<Ct.length;)L.has(Ct[qe])||(Ke=qe);if(xt!=null||Ke!=null)if(Ue){let Kt=xt==null?-1/0:F(Pt[xt],I,ke,0),cn=Ke==null?1/0:F(Pt[Ke],I,ke,0),kn=at-Kt,Ht=cn-at;kn<=Ht?kn<=Oe&&(Te=xt):Ht<=Oe&&(Te=Ke)}else Te=Ke==null?xt:xt==null?Ke:de-xt<=Ke-de?xt:Ke}else Ue&&Dn(at-F(Pt[de],I,ke,0))>Oe&&(Te=null);return Te}}let et=A=>{te.event=A};te.idxs=ne,te._lock=!1;let ge=te.points;ge.show=Mt(ge.show),ge.size=Mt(ge.size),ge.stroke=Mt(ge.stroke),ge.width=Mt(ge.width),ge.fill=Mt(ge.fill);let ze=i.focus=An({},n.focus||{alpha:.3},te.focus),tt=ze.prox>=0,Ie=tt&&ge.one,ut=[],jt=[],oi=[];function Na(A,L){let U=ge.show(i,L);if(U instanceof HTMLElement)return Ni(U,AC),Ni(U,A.class),Rs(U,-10,-10,G,Le),y.insertBefore(U,ut[L]),U}function xo(A,L){if(s==1||L>0){let U=s==1&&S[A.scale].time,B=A.value;A.value=U?Sy(B)?Ry(X,Cy(B,k)):B||J:B||zR,A.label=A.label||(U?LR:IR)}if(Ie||L>0){A.width=A.width==null?1:A.width,A.paths=A.paths||e2||WC,A.fillTo=Mt(A.fillTo||$R),A.pxAlign=+Rt(A.pxAlign,v),A.pxRound=By(A.pxAlign),A.stroke=Mt(A.stroke||null),A.fill=Mt(A.fill||null),A._stroke=A._fill=A._paths=A._focus=null;let U=VR(di(1,A.width),1),B=A.points=An({},{size:U,width:di(1,U*.2),stroke:A.stroke,space:U*2,paths:t2,_stroke:null,_fill:null},A.points);B.show=Mt(B.show),B.filter=Mt(B.filter),B.fill=Mt(B.fill),B.stroke=Mt(B.stroke),B.paths=Mt(B.paths),B.pxAlign=A.pxAlign}if(j){let U=Gt(A,L);We.splice(L,0,U[0]),Ge.splice(L,0,U[1]),pe.values.push(null)}if(he){ne.splice(L,0,null);let U=null;Ie?L==0&&(U=Na(A,L)):L>0&&(U=Na(A,L)),ut.splice(L,0,U),jt.splice(L,0,0),oi.splice(L,0,0)}Bn("addSeries",L)}function bf(A,L){L=L??_.length,A=s==1?cm(A,L,Iy,Oy):cm(A,L,{},Fy),_.splice(L,0,A),xo(_[L],L)}i.addSeries=bf;function ic(A){if(_.splice(A,1),j){pe.values.splice(A,1),Ge.splice(A,1);let L=We.splice(A,1)[0];En(null,L.firstChild),L.remove()}he&&(ne.splice(A,1),ut.splice(A,1)[0].remove(),jt.splice(A,1),oi.splice(A,1)),Bn("delSeries",A)}i.delSeries=ic;let cs=[!1,!1,!1,!1];function Ps(A,L){if(A._show=A.show,A.show){let U=A.side%2,B=S[A.scale];B==null&&(A.scale=U?_[1].scale:b,B=S[A.scale]);let $=B.time;A.size=Mt(A.size),A.space=Mt(A.space),A.rotate=Mt(A.rotate),Lr(A.incrs)&&A.incrs.forEach(de=>{!Nr.has(de)&&Nr.set(de,Zy(de))}),A.incrs=Mt(A.incrs||(B.distr==2?fR:$?x==1?pR:_R:uo)),A.splits=Mt(A.splits||($&&B.distr==1?se:B.distr==3?rm:B.distr==4?FR:DR)),A.stroke=Mt(A.stroke),A.grid.stroke=Mt(A.grid.stroke),A.ticks.stroke=Mt(A.ticks.stroke),A.border.stroke=Mt(A.border.stroke);let ee=A.values;A.values=Lr(ee)&&!Lr(ee[0])?Mt(ee):$?Lr(ee)?Ey(X,Ay(ee,k)):Sy(ee)?vR(X,ee):ee||q:ee||NR,A.filter=Mt(A.filter||(B.distr>=3&&B.log==10?BR:B.distr==3&&B.log==2?kR:jy)),A.font=Gy(A.font),A.labelFont=Gy(A.labelFont),A._size=A.size(i,null,L,0),A._space=A._rotate=A._incrs=A._found=A._splits=A._values=null,A._size>0&&(cs[L]=!0,A._el=Wi(SC,f))}}function Is(A,L,U,B){let[$,ee,de,ye]=U,Te=L%2,Oe=0;return Te==0&&(ye||ee)&&(Oe=L==0&&!$||L==2&&!de?Nn(Py.size/3):0),Te==1&&($||de)&&(Oe=L==1&&!ee||L==3&&!ye?Nn(Ny.size/2):0),Oe}let Da=i.padding=(n.padding||[Is,Is,Is,Is]).map(A=>Mt(Rt(A,Is))),Xi=i._padding=Da.map((A,L)=>A(i,L,cs,0)),an,dn=null,pn=null,us=s==1?_[0].idxs:null,xi=null,rr=!1;function Fa(A,L){if(e=A??[],i.data=i._data=e,s==2){an=0;for(let U=1;U<_.length;U++)an+=e[U][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),xi=e[0],an=xi.length;let U=e;if(E==2){U=e.slice();let B=U[0]=Array(an);for(let $=0;$<an;$++)B[$]=$}i._data=e=U}if(ft(!0),Bn("setData"),E==2&&(we=!0),L!==!1){let U=I;U.auto(i,rr)?Oa():lr(b,U.min,U.max),re=re||te.left>=0,ve=!0,Zn()}}i.setData=Fa;function Oa(){rr=!0;let A,L;s==1&&(an>0?(dn=us[0]=0,pn=us[1]=an-1,A=e[0][dn],L=e[0][pn],E==2?(A=dn,L=pn):A==L&&(E==3?[A,L]=ef(A,A,I.log,!1):E==4?[A,L]=dm(A,A,I.log,!1):I.time?L=A+Nn(86400/x):[A,L]=Zh(A,L,pm,!0))):(dn=us[0]=A=null,pn=us[1]=L=null)),lr(b,A,L)}let yo,or,vo,N,W,ie,Z,K,Re,Ne;function Pe(A,L,U,B,$,ee){A??=ry,U??=gm,B??="butt",$??=ry,ee??="round",A!=yo&&(h.strokeStyle=yo=A),$!=or&&(h.fillStyle=or=$),L!=vo&&(h.lineWidth=vo=L),ee!=W&&(h.lineJoin=W=ee),B!=ie&&(h.lineCap=ie=B),U!=N&&h.setLineDash(N=U)}function De(A,L,U,B){L!=or&&(h.fillStyle=or=L),A!=Z&&(h.font=Z=A),U!=K&&(h.textAlign=K=U),B!=Re&&(h.textBaseline=Re=B)}function He(A,L,U,B,$=0){if(B.length>0&&A.auto(i,rr)&&(L==null||L.min==null)){let ee=Rt(dn,0),de=Rt(pn,B.length-1),ye=U.min==null?BC(B,ee,de,$,A.distr==3):[U.min,U.max];A.min=ls(A.min,U.min=ye[0]),A.max=di(A.max,U.max=ye[1])}}let st={min:null,max:null};function gt(){for(let B in S){let $=S[B];z[B]==null&&($.min==null||z[b]!=null&&$.auto(i,rr))&&(z[B]=st)}for(let B in S){let $=S[B];z[B]==null&&$.from!=null&&z[$.from]!=null&&(z[B]=st)}z[b]!=null&&ft(!0);let A={};for(let B in z){let $=z[B];if($!=null){let ee=A[B]=Aa(S[B],qC);if($.min!=null)An(ee,$);else if(B!=b||s==2)if(an==0&&ee.from==null){let de=ee.range(i,null,null,B);ee.min=de[0],ee.max=de[1]}else ee.min=Xt,ee.max=-Xt}}if(an>0){_.forEach((B,$)=>{if(s==1){let ee=B.scale,de=z[ee];if(de==null)return;let ye=A[ee];if($==0){let Te=ye.range(i,ye.min,ye.max,ee);ye.min=Te[0],ye.max=Te[1],dn=as(ye.min,e[0]),pn=as(ye.max,e[0]),pn-dn>1&&(e[0][dn]<ye.min&&dn++,e[0][pn]>ye.max&&pn--),B.min=xi[dn],B.max=xi[pn]}else B.show&&B.auto&&He(ye,de,B,e[$],B.sorted);B.idxs[0]=dn,B.idxs[1]=pn}else if($>0&&B.show&&B.auto){let[ee,de]=B.facets,ye=ee.scale,Te=de.scale,[Oe,Ue]=e[$],ke=A[ye],at=A[Te];ke!=null&&He(ke,z[ye],ee,Oe,ee.sorted),at!=null&&He(at,z[Te],de,Ue,de.sorted),B.min=de.min,B.max=de.max}});for(let B in A){let $=A[B],ee=z[B];if($.from==null&&(ee==null||ee.min==null)){let de=$.range(i,$.min==Xt?null:$.min,$.max==-Xt?null:$.max,B);$.min=de[0],$.max=de[1]}}}for(let B in A){let $=A[B];if($.from!=null){let ee=A[$.from];if(ee.min==null)$.min=$.max=null;else{let de=$.range(i,ee.min,ee.max,B);$.min=de[0],$.max=de[1]}}}let L={},U=!1;for(let B in A){let $=A[B],ee=S[B];if(ee.min!=$.min||ee.max!=$.max){ee.min=$.min,ee.max=$.max;let de=ee.distr;ee._min=de==3?ir(ee.min):de==4?Jp(ee.min,ee.asinh):de==100?ee.fwd(ee.min):ee.min,ee._max=de==3?ir(ee.max):de==4?Jp(ee.max,ee.asinh):de==100?ee.fwd(ee.max):ee.max,L[B]=U=!0}}if(U){_.forEach((B,$)=>{s==2?$>0&&L.y&&(B._paths=null):L[B.scale]&&(B._paths=null)});for(let B in L)we=!0,Bn("setScale",B);he&&te.left>=0&&(re=ve=!0)}for(let B in z)z[B]=null}function Ve(A){let L=sm(dn-1,0,an-1),U=sm(pn+1,0,an-1);for(;A[L]==null&&L>0;)L--;for(;A[U]==null&&U<an-1;)U++;return[L,U]}function _t(){if(an>0){let A=_.some(L=>L._focus)&&Ne!=ze.alpha;A&&(h.globalAlpha=Ne=ze.alpha),_.forEach((L,U)=>{if(U>0&&L.show&&(rn(U,!1),rn(U,!0),L._paths==null)){let B=Ne;Ne!=L.alpha&&(h.globalAlpha=Ne=L.alpha);let $=s==2?[0,e[U][0].length-1]:Ve(e[U]);L._paths=L.paths(i,U,$[0],$[1]),Ne!=B&&(h.globalAlpha=Ne=B)}}),_.forEach((L,U)=>{if(U>0&&L.show){let B=Ne;Ne!=L.alpha&&(h.globalAlpha=Ne=L.alpha),L._paths!=null&&Ut(U,!1);{let $=L._paths!=null?L._paths.gaps:null,ee=L.points.show(i,U,dn,pn,$),de=L.points.filter(i,U,ee,$);(ee||de)&&(L.points._paths=L.points.paths(i,U,dn,pn,de),Ut(U,!0))}Ne!=B&&(h.globalAlpha=Ne=B),Bn("drawSeries",U)}}),A&&(h.globalAlpha=Ne=1)}}function rn(A,L){let U=L?_[A].points:_[A];U._stroke=U.stroke(i,A),U._fill=U.fill(i,A)}function Ut(A,L){let U=L?_[A].points:_[A],{stroke:B,fill:$,clip:ee,flags:de,_stroke:ye=U._stroke,_fill:Te=U._fill,_width:Oe=U.width}=U._paths;Oe=qt(Oe*Nt,3);let Ue=null,ke=Oe%2/2;L&&Te==null&&(Te=Oe>0?"#fff":ye);let at=U.pxAlign==1&&ke>0;if(at&&h.translate(ke,ke),!L){let Pt=O-Oe/2,Ct=P-Oe/2,xt=Y+Oe,Ke=xe+Oe;Ue=new Path2D,Ue.rect(Pt,Ct,xt,Ke)}L?Be(ye,Oe,U.dash,U.cap,Te,B,$,de,ee):Bt(A,ye,Oe,U.dash,U.cap,Te,B,$,de,Ue,ee),at&&h.translate(-ke,-ke)}function Bt(A,L,U,B,$,ee,de,ye,Te,Oe,Ue){let ke=!1;Te!=0&&T.forEach((at,Pt)=>{if(at.series[0]==A){let Ct=_[at.series[1]],xt=e[at.series[1]],Ke=(Ct._paths||Jl).band;Lr(Ke)&&(Ke=at.dir==1?Ke[0]:Ke[1]);let qe,Kt=null;Ct.show&&Ke&&zC(xt,dn,pn)?(Kt=at.fill(i,Pt)||ee,qe=Ct._paths.clip):Ke=null,Be(L,U,B,$,Kt,de,ye,Te,Oe,Ue,qe,Ke),ke=!0}}),ke||Be(L,U,B,$,ee,de,ye,Te,Oe,Ue)}let Cn=Ea|am;function Be(A,L,U,B,$,ee,de,ye,Te,Oe,Ue,ke){Pe(A,L,U,B,$),(Te||Oe||ke)&&(h.save(),Te&&h.clip(Te),Oe&&h.clip(Oe)),ke?(ye&Cn)==Cn?(h.clip(ke),Ue&&h.clip(Ue),yt($,de),xn(A,ee,L)):ye&am?(yt($,de),h.clip(ke),xn(A,ee,L)):ye&Ea&&(h.save(),h.clip(ke),Ue&&h.clip(Ue),yt($,de),h.restore(),xn(A,ee,L)):(yt($,de),xn(A,ee,L)),(Te||Oe||ke)&&h.restore()}function xn(A,L,U){U>0&&(L instanceof Map?L.forEach((B,$)=>{h.strokeStyle=yo=$,h.stroke(B)}):L!=null&&A&&h.stroke(L))}function yt(A,L){L instanceof Map?L.forEach((U,B)=>{h.fillStyle=or=B,h.fill(U)}):L!=null&&A&&h.fill(L)}function Ls(A,L,U,B){let $=M[A],ee;if(B<=0)ee=[0,0];else{let de=$._space=$.space(i,A,L,U,B),ye=$._incrs=$.incrs(i,A,L,U,B,de);ee=a2(L,U,ye,B,de)}return $._found=ee}function yn(A,L,U,B,$,ee,de,ye,Te,Oe){let Ue=de%2/2;v==1&&h.translate(Ue,Ue),Pe(ye,de,Te,Oe,ye),h.beginPath();let ke,at,Pt,Ct,xt=$+(B==0||B==3?-ee:ee);U==0?(at=$,Ct=xt):(ke=$,Pt=xt);for(let Ke=0;Ke<A.length;Ke++)L[Ke]!=null&&(U==0?ke=Pt=A[Ke]:at=Ct=A[Ke],h.moveTo(ke,at),h.lineTo(Pt,Ct));h.stroke(),v==1&&h.translate(-Ue,-Ue)}function bo(A){let L=!0;return M.forEach((U,B)=>{if(!U.show)return;let $=S[U.scale];if($.min==null){U._show&&(L=!1,U._show=!1,ft(!1));return}else U._show||(L=!1,U._show=!0,ft(!1));let ee=U.side,de=ee%2,{min:ye,max:Te}=$,[Oe,Ue]=Ls(B,ye,Te,de==0?G:Le);if(Ue==0)return;let ke=$.distr==2,at=U._splits=U.splits(i,B,ye,Te,Oe,Ue,ke),Pt=$.distr==2?at.map(qe=>xi[qe]):at,Ct=$.distr==2?xi[at[1]]-xi[at[0]]:Oe,xt=U._values=U.values(i,U.filter(i,Pt,B,Ue,Ct),B,Ue,Ct);U._rotate=ee==2?U.rotate(i,xt,B,Ue):0;let Ke=U._size;U._size=$i(U.size(i,xt,B,A)),Ke!=null&&U._size!=Ke&&(L=!1)}),L}function hs(A){let L=!0;return Da.forEach((U,B)=>{let $=U(i,B,cs,A);$!=Xi[B]&&(L=!1),Xi[B]=$}),L}function Ns(){for(let A=0;A<M.length;A++){let L=M[A];if(!L.show||!L._show)continue;let U=L.side,B=U%2,$,ee,de=L.stroke(i,A),ye=U==0||U==3?-1:1,[Te,Oe]=L._found;if(L.label!=null){let ci=L.labelGap*ye,bi=Nn((L._lpos+ci)*Nt);De(L.labelFont[0],de,"center",U==2?"top":sy),h.save(),B==1?($=ee=0,h.translate(bi,Nn(P+xe/2)),h.rotate((U==3?-jh:jh)/2)):($=Nn(O+Y/2),ee=bi);let Ur=qy(L.label)?L.label(i,A,Te,Oe):L.label;h.fillText(Ur,$,ee),h.restore()}if(Oe==0)continue;let Ue=S[L.scale],ke=B==0?Y:xe,at=B==0?O:P,Pt=L._splits,Ct=Ue.distr==2?Pt.map(ci=>xi[ci]):Pt,xt=Ue.distr==2?xi[Pt[1]]-xi[Pt[0]]:Te,Ke=L.ticks,qe=L.border,Kt=Ke.show?Ke.size:0,cn=Nn(Kt*Nt),kn=Nn((L.alignTo==2?L._size-Kt-L.gap:L.gap)*Nt),Ht=L._rotate*-jh/180,un=g(L._pos*Nt),yi=(cn+kn)*ye,li=un+yi;ee=B==0?li:0,$=B==1?li:0;let Oi=L.font[0],qi=L.align==1?ba:L.align==2?qp:Ht>0?ba:Ht<0?qp:B==0?"center":U==3?qp:ba,ps=Ht||B==1?"middle":U==2?"top":sy;De(Oi,de,qi,ps);let vi=L.font[1]*L.lineGap,Ui=Pt.map(ci=>g(a(ci,Ue,ke,at))),Yi=L._values;for(let ci=0;ci<Yi.length;ci++){let bi=Yi[ci];if(bi!=null){B==0?$=Ui[ci]:ee=Ui[ci],bi=""+bi;let Ur=bi.indexOf(`
`)==-1?[bi]:bi.split(/\n/gm);for(let ui=0;ui<Ur.length;ui++){let cg=Ur[ui];Ht?(h.save(),h.translate($,ee+ui*vi),h.rotate(Ht),h.fillText(cg,0,0),h.restore()):h.fillText(cg,$,ee+ui*vi)}}}Ke.show&&yn(Ui,Ke.filter(i,Ct,A,Oe,xt),B,U,un,cn,qt(Ke.width*Nt,3),Ke.stroke(i,A),Ke.dash,Ke.cap);let ms=L.grid;ms.show&&yn(Ui,ms.filter(i,Ct,A,Oe,xt),B,B==0?2:1,B==0?P:O,B==0?xe:Y,qt(ms.width*Nt,3),ms.stroke(i,A),ms.dash,ms.cap),qe.show&&yn([un],[1],B==0?1:0,B==0?1:2,B==1?P:O,B==1?xe:Y,qt(qe.width*Nt,3),qe.stroke(i,A),qe.dash,qe.cap)}Bn("drawAxes")}function ft(A){_.forEach((L,U)=>{U>0&&(L._paths=null,A&&(s==1?(L.min=null,L.max=null):L.facets.forEach(B=>{B.min=null,B.max=null})))})}let ln=!1,ai=!1,kt=[];function vn(){ai=!1;for(let A=0;A<kt.length;A++)Bn(...kt[A]);kt.length=0}function Zn(){ln||(eR($m),ln=!0)}function sc(A,L=!1){ln=!0,ai=L,A(i),$m(),L&&kt.length>0&&queueMicrotask(vn)}i.batch=sc;function $m(){if(fe&&(gt(),fe=!1),we&&(Ce(),we=!1),Se){if(tn(d,ba,Ze),tn(d,"top",lt),tn(d,Xl,G),tn(d,ql,Le),tn(y,ba,Ze),tn(y,"top",lt),tn(y,Xl,G),tn(y,ql,Le),tn(f,Xl,on),tn(f,ql,_n),u.width=Nn(on*Nt),u.height=Nn(_n*Nt),M.forEach(({_el:A,_show:L,_size:U,_pos:B,side:$})=>{if(A!=null)if(L){let ee=$===3||$===0?U:0,de=$%2==1;tn(A,de?"left":"top",B-ee),tn(A,de?"width":"height",U),tn(A,de?"top":"left",de?lt:Ze),tn(A,de?"height":"width",de?Le:G),nm(A,ho)}else Ni(A,ho)}),yo=or=vo=W=ie=Z=K=Re=N=null,Ne=1,ka(!0),Ze!=Ee||lt!=$t||G!=$e||Le!=Ye){ft(!1);let A=G/$e,L=Le/Ye;if(he&&!re&&te.left>=0){te.left*=A,te.top*=L,So&&Rs(So,Nn(te.left),0,G,Le),Mo&&Rs(Mo,0,Nn(te.top),G,Le);for(let U=0;U<ut.length;U++){let B=ut[U];B!=null&&(jt[U]*=A,oi[U]*=L,Rs(B,$i(jt[U]),$i(oi[U]),G,Le))}}if(Zt.show&&!le&&Zt.left>=0&&Zt.width>0){Zt.left*=A,Zt.width*=A,Zt.top*=L,Zt.height*=L;for(let U in Ef)tn(Ao,U,Zt[U])}Ee=Ze,$t=lt,$e=G,Ye=Le}Bn("setSize"),Se=!1}on>0&&_n>0&&(h.clearRect(0,0,u.width,u.height),Bn("drawClear"),w.forEach(A=>A()),Bn("draw")),Zt.show&&le&&(rc(Zt),le=!1),he&&re&&(Or(null,!0,!1),re=!1),pe.show&&pe.live&&ve&&(Tf(),ve=!1),l||(l=!0,i.status=1,Bn("ready")),rr=!1,ln=!1}i.redraw=(A,L)=>{we=L||!1,A!==!1?lr(b,I.min,I.max):Zn()};function Sf(A,L){let U=S[A];if(U.from==null){if(an==0){let B=U.range(i,L.min,L.max,A);L.min=B[0],L.max=B[1]}if(L.min>L.max){let B=L.min;L.min=L.max,L.max=B}if(an>1&&L.min!=null&&L.max!=null&&L.max-L.min<1e-16)return;A==b&&U.distr==2&&an>0&&(L.min=as(L.min,e[0]),L.max=as(L.max,e[0]),L.min==L.max&&L.max++),z[A]=L,fe=!0,Zn()}}i.setScale=Sf;let Mf,wf,So,Mo,Xm,qm,wo,To,Ym,jm,Jt,sn,ar=!1,Xn=te.drag,On=Xn.x,Un=Xn.y;he&&(te.x&&(Mf=Wi(wC,y)),te.y&&(wf=Wi(TC,y)),I.ori==0?(So=Mf,Mo=wf):(So=wf,Mo=Mf),Jt=te.left,sn=te.top);let Zt=i.select=An({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ao=Zt.show?Wi(MC,Zt.over?y:d):null;function rc(A,L){if(Zt.show){for(let U in A)Zt[U]=A[U],U in Ef&&tn(Ao,U,A[U]);L!==!1&&Bn("setSelect")}}i.setSelect=rc;function Ob(A){if(_[A].show)j&&nm(We[A],ho);else if(j&&Ni(We[A],ho),he){let U=Ie?ut[0]:ut[A];U!=null&&Rs(U,-10,-10,G,Le)}}function lr(A,L,U){Sf(A,{min:L,max:U})}function fs(A,L,U,B){L.focus!=null&&Vb(A),L.show!=null&&_.forEach(($,ee)=>{ee>0&&(A==ee||A==null)&&($.show=L.show,Ob(ee),s==2?(lr($.facets[0].scale,null,null),lr($.facets[1].scale,null,null)):lr($.scale,null,null),Zn())}),U!==!1&&Bn("setSeries",A,L),B&&za("setSeries",i,A,L)}i.setSeries=fs;function Ub(A,L){An(T[A],L)}function Bb(A,L){A.fill=Mt(A.fill||null),A.dir=Rt(A.dir,-1),L=L??T.length,T.splice(L,0,A)}function kb(A){A==null?T.length=0:T.splice(A,1)}i.addBand=Bb,i.setBand=Ub,i.delBand=kb;function zb(A,L){_[A].alpha=L,he&&ut[A]!=null&&(ut[A].style.opacity=L),j&&We[A]&&(We[A].style.opacity=L)}let Ds,cr,Fr,Eo={focus:!0};function Vb(A){if(A!=Fr){let L=A==null,U=ze.alpha!=1;_.forEach((B,$)=>{if(s==1||$>0){let ee=L||$==0||$==A;B._focus=L?null:ee,U&&zb($,ee?1:ze.alpha)}}),Fr=A,U&&Zn()}}j&&tt&&Tt(ly,Q,A=>{te._lock||(et(A),Fr!=null&&fs(null,Eo,!0,bn.setSeries))});function ds(A,L,U){let B=S[L];U&&(A=A/Nt-(B.ori==1?lt:Ze));let $=G;B.ori==1&&($=Le,A=$-A),B.dir==-1&&(A=$-A);let ee=B._min,de=B._max,ye=A/$,Te=ee+(de-ee)*ye,Oe=B.distr;return Oe==3?wa(10,Te):Oe==4?GC(Te,B.asinh):Oe==100?B.bwd(Te):Te}function Gb(A,L){let U=ds(A,b,L);return as(U,e[0],dn,pn)}i.valToIdx=A=>as(A,e[0]),i.posToIdx=Gb,i.posToVal=ds,i.valToPos=(A,L,U)=>S[L].ori==0?r(A,S[L],U?Y:G,U?O:0):o(A,S[L],U?xe:Le,U?P:0),i.setCursor=(A,L,U)=>{Jt=A.left,sn=A.top,Or(null,L,U)};function Jm(A,L){tn(Ao,ba,Zt.left=A),tn(Ao,Xl,Zt.width=L)}function Zm(A,L){tn(Ao,"top",Zt.top=A),tn(Ao,ql,Zt.height=L)}let Ua=I.ori==0?Jm:Zm,Ba=I.ori==1?Jm:Zm;function Hb(){if(j&&pe.live)for(let A=s==2?1:0;A<_.length;A++){if(A==0&&ht)continue;let L=pe.values[A],U=0;for(let B in L)Ge[A][U++].firstChild.nodeValue=L[B]}}function Tf(A,L){if(A!=null&&(A.idxs?A.idxs.forEach((U,B)=>{ne[B]=U}):XC(A.idx)||ne.fill(A.idx),pe.idx=ne[0]),j&&pe.live){for(let U=0;U<_.length;U++)(U>0||s==1&&!ht)&&Wb(U,ne[U]);Hb()}ve=!1,L!==!1&&Bn("setLegend")}i.setLegend=Tf;function Wb(A,L){let U=_[A],B=A==0&&E==2?xi:e[A],$;ht?$=U.values(i,A,L)??ot:($=U.value(i,L==null?null:B[L],A,L),$=$==null?ot:{_:$}),pe.values[A]=$}function Or(A,L,U){Ym=Jt,jm=sn,[Jt,sn]=te.move(i,Jt,sn),te.left=Jt,te.top=sn,he&&(So&&Rs(So,Nn(Jt),0,G,Le),Mo&&Rs(Mo,0,Nn(sn),G,Le));let B,$=dn>pn;Ds=Xt,cr=null;let ee=I.ori==0?G:Le,de=I.ori==1?G:Le;if(Jt<0||an==0||$){B=te.idx=null;for(let ye=0;ye<_.length;ye++){let Te=ut[ye];Te!=null&&Rs(Te,-10,-10,G,Le)}tt&&fs(null,Eo,!0,A==null&&bn.setSeries),pe.live&&(ne.fill(B),ve=!0)}else{let ye,Te,Oe;s==1&&(ye=I.ori==0?Jt:sn,Te=ds(ye,b),B=te.idx=as(Te,e[0],dn,pn),Oe=F(e[0][B],I,ee,0));let Ue=-10,ke=-10,at=0,Pt=0,Ct=!0,xt="",Ke="";for(let qe=s==2?1:0;qe<_.length;qe++){let Kt=_[qe],cn=ne[qe],kn=cn==null?null:s==1?e[qe][cn]:e[qe][1][cn],Ht=te.dataIdx(i,qe,B,Te),un=Ht==null?null:s==1?e[qe][Ht]:e[qe][1][Ht];if(ve=ve||un!=kn||Ht!=cn,ne[qe]=Ht,qe>0&&Kt.show){let yi=Ht==null?-10:Ht==B?Oe:F(s==1?e[0][Ht]:e[qe][0][Ht],I,ee,0),li=un==null?-10:D(un,s==1?S[Kt.scale]:S[Kt.facets[1].scale],de,0);if(tt&&un!=null){let Oi=I.ori==1?Jt:sn,qi=Dn(ze.dist(i,qe,Ht,li,Oi));if(qi<Ds){let ps=ze.bias;if(ps!=0){let vi=ds(Oi,Kt.scale),Ui=un>=0?1:-1,Yi=vi>=0?1:-1;Yi==Ui&&(Yi==1?ps==1?un>=vi:un<=vi:ps==1?un<=vi:un>=vi)&&(Ds=qi,cr=qe)}else Ds=qi,cr=qe}}if(ve||Ie){let Oi,qi;I.ori==0?(Oi=yi,qi=li):(Oi=li,qi=yi);let ps,vi,Ui,Yi,ms,ci,bi=!0,Ur=ge.bbox;if(Ur!=null){bi=!1;let ui=Ur(i,qe);Ui=ui.left,Yi=ui.top,ps=ui.width,vi=ui.height}else Ui=Oi,Yi=qi,ps=vi=ge.size(i,qe);if(ci=ge.fill(i,qe),ms=ge.stroke(i,qe),Ie)qe==cr&&Ds<=ze.prox&&(Ue=Ui,ke=Yi,at=ps,Pt=vi,Ct=bi,xt=ci,Ke=ms);else{let ui=ut[qe];ui!=null&&(jt[qe]=Ui,oi[qe]=Yi,my(ui,ps,vi,bi),dy(ui,ci,ms),Rs(ui,$i(Ui),$i(Yi),G,Le))}}}}if(Ie){let qe=ze.prox,Kt=Fr==null?Ds<=qe:Ds>qe||cr!=Fr;if(ve||Kt){let cn=ut[0];cn!=null&&(jt[0]=Ue,oi[0]=ke,my(cn,at,Pt,Ct),dy(cn,xt,Ke),Rs(cn,$i(Ue),$i(ke),G,Le))}}}if(Zt.show&&ar)if(A!=null){let[ye,Te]=bn.scales,[Oe,Ue]=bn.match,[ke,at]=A.cursor.sync.scales,Pt=A.cursor.drag;if(On=Pt._x,Un=Pt._y,On||Un){let{left:Ct,top:xt,width:Ke,height:qe}=A.select,Kt=A.scales[ke].ori,cn=A.posToVal,kn,Ht,un,yi,li,Oi=ye!=null&&Oe(ye,ke),qi=Te!=null&&Ue(Te,at);Oi&&On?(Kt==0?(kn=Ct,Ht=Ke):(kn=xt,Ht=qe),un=S[ye],yi=F(cn(kn,ke),un,ee,0),li=F(cn(kn+Ht,ke),un,ee,0),Ua(ls(yi,li),Dn(li-yi))):Ua(0,ee),qi&&Un?(Kt==1?(kn=Ct,Ht=Ke):(kn=xt,Ht=qe),un=S[Te],yi=D(cn(kn,at),un,de,0),li=D(cn(kn+Ht,at),un,de,0),Ba(ls(yi,li),Dn(li-yi))):Ba(0,de)}else Cf()}else{let ye=Dn(Ym-Xm),Te=Dn(jm-qm);if(I.ori==1){let at=ye;ye=Te,Te=at}On=Xn.x&&ye>=Xn.dist,Un=Xn.y&&Te>=Xn.dist;let Oe=Xn.uni;Oe!=null?On&&Un&&(On=ye>=Oe,Un=Te>=Oe,!On&&!Un&&(Te>ye?Un=!0:On=!0)):Xn.x&&Xn.y&&(On||Un)&&(On=Un=!0);let Ue,ke;On&&(I.ori==0?(Ue=wo,ke=Jt):(Ue=To,ke=sn),Ua(ls(Ue,ke),Dn(ke-Ue)),Un||Ba(0,de)),Un&&(I.ori==1?(Ue=wo,ke=Jt):(Ue=To,ke=sn),Ba(ls(Ue,ke),Dn(ke-Ue)),On||Ua(0,ee)),!On&&!Un&&(Ua(0,0),Ba(0,0))}if(Xn._x=On,Xn._y=Un,A==null){if(U){if(lg!=null){let[ye,Te]=bn.scales;bn.values[0]=ye!=null?ds(I.ori==0?Jt:sn,ye):null,bn.values[1]=Te!=null?ds(I.ori==1?Jt:sn,Te):null}za(Yp,i,Jt,sn,G,Le,B)}if(tt){let ye=U&&bn.setSeries,Te=ze.prox;Fr==null?Ds<=Te&&fs(cr,Eo,!0,ye):Ds>Te?fs(null,Eo,!0,ye):cr!=Fr&&fs(cr,Eo,!0,ye)}}ve&&(pe.idx=B,Tf()),L!==!1&&Bn("setCursor")}let ur=null;Object.defineProperty(i,"rect",{get(){return ur==null&&ka(!1),ur}});function ka(A=!1){A?ur=null:(ur=y.getBoundingClientRect(),Bn("syncRect",ur))}function Km(A,L,U,B,$,ee,de){te._lock||ar&&A!=null&&A.movementX==0&&A.movementY==0||(Af(A,L,U,B,$,ee,de,!1,A!=null),A!=null?Or(null,!0,!0):Or(L,!0,!1))}function Af(A,L,U,B,$,ee,de,ye,Te){if(ur==null&&ka(!1),et(A),A!=null)U=A.clientX-ur.left,B=A.clientY-ur.top;else{if(U<0||B<0){Jt=-10,sn=-10;return}let[Oe,Ue]=bn.scales,ke=L.cursor.sync,[at,Pt]=ke.values,[Ct,xt]=ke.scales,[Ke,qe]=bn.match,Kt=L.axes[0].side%2==1,cn=I.ori==0?G:Le,kn=I.ori==1?G:Le,Ht=Kt?ee:$,un=Kt?$:ee,yi=Kt?B:U,li=Kt?U:B;if(Ct!=null?U=Ke(Oe,Ct)?a(at,S[Oe],cn,0):-10:U=cn*(yi/Ht),xt!=null?B=qe(Ue,xt)?a(Pt,S[Ue],kn,0):-10:B=kn*(li/un),I.ori==1){let Oi=U;U=B,B=Oi}}Te&&(L==null||L.cursor.event.type==Yp)&&((U<=1||U>=G-1)&&(U=co(U,G)),(B<=1||B>=Le-1)&&(B=co(B,Le))),ye?(Xm=U,qm=B,[wo,To]=te.move(i,U,B)):(Jt=U,sn=B)}let Ef={width:0,height:0,left:0,top:0};function Cf(){rc(Ef,!1)}let Qm,eg,tg,ng;function ig(A,L,U,B,$,ee,de){ar=!0,On=Un=Xn._x=Xn._y=!1,Af(A,L,U,B,$,ee,de,!0,!1),A!=null&&(Tt(jp,em,sg,!1),za(oy,i,wo,To,G,Le,null));let{left:ye,top:Te,width:Oe,height:Ue}=Zt;Qm=ye,eg=Te,tg=Oe,ng=Ue}function sg(A,L,U,B,$,ee,de){ar=Xn._x=Xn._y=!1,Af(A,L,U,B,$,ee,de,!1,!0);let{left:ye,top:Te,width:Oe,height:Ue}=Zt,ke=Oe>0||Ue>0,at=Qm!=ye||eg!=Te||tg!=Oe||ng!=Ue;if(ke&&at&&rc(Zt),Xn.setScale&&ke&&at){let Pt=ye,Ct=Oe,xt=Te,Ke=Ue;if(I.ori==1&&(Pt=Te,Ct=Ue,xt=ye,Ke=Oe),On&&lr(b,ds(Pt,b),ds(Pt+Ct,b)),Un)for(let qe in S){let Kt=S[qe];qe!=b&&Kt.from==null&&Kt.min!=Xt&&lr(qe,ds(xt+Ke,qe),ds(xt,qe))}Cf()}else te.lock&&(te._lock=!te._lock,Or(L,!0,A!=null));A!=null&&(En(jp,em),za(jp,i,Jt,sn,G,Le,null))}function $b(A,L,U,B,$,ee,de){if(te._lock)return;et(A);let ye=ar;if(ar){let Te=!0,Oe=!0,Ue=10,ke,at;I.ori==0?(ke=On,at=Un):(ke=Un,at=On),ke&&at&&(Te=Jt<=Ue||Jt>=G-Ue,Oe=sn<=Ue||sn>=Le-Ue),ke&&Te&&(Jt=Jt<wo?0:G),at&&Oe&&(sn=sn<To?0:Le),Or(null,!0,!0),ar=!1}Jt=-10,sn=-10,ne.fill(null),Or(null,!0,!0),ye&&(ar=ye)}function rg(A,L,U,B,$,ee,de){te._lock||(et(A),Oa(),Cf(),A!=null&&za(cy,i,Jt,sn,G,Le,null))}function og(){M.forEach(l2),V(i.width,i.height,!0)}fo(Jh,Ma,og);let Co={};Co.mousedown=ig,Co.mousemove=Km,Co.mouseup=sg,Co.dblclick=rg,Co.setSeries=(A,L,U,B)=>{let $=bn.match[2];U=$(i,L,U),U!=-1&&fs(U,B,!0,!1)},he&&(Tt(oy,y,ig),Tt(Yp,y,Km),Tt(ay,y,A=>{et(A),ka(!1)}),Tt(ly,y,$b),Tt(cy,y,rg),lm.add(i),i.syncRect=ka);let oc=i.hooks=n.hooks||{};function Bn(A,L,U){ai?kt.push([A,L,U]):A in oc&&oc[A].forEach(B=>{B.call(null,i,L,U)})}(n.plugins||[]).forEach(A=>{for(let L in A.hooks)oc[L]=(oc[L]||[]).concat(A.hooks[L])});let ag=(A,L,U)=>U,bn=An({key:null,setSeries:!1,filters:{pub:vy,sub:vy},scales:[b,_[1]?_[1].scale:null],match:[by,by,ag],values:[null,null]},te.sync);bn.match.length==2&&bn.match.push(ag),te.sync=bn;let lg=bn.key,Rf=_v(lg);function za(A,L,U,B,$,ee,de){bn.filters.pub(A,L,U,B,$,ee,de)&&Rf.pub(A,L,U,B,$,ee,de)}Rf.sub(i);function Xb(A,L,U,B,$,ee,de){bn.filters.sub(A,L,U,B,$,ee,de)&&Co[A](null,L,U,B,$,ee,de)}i.pub=Xb;function qb(){Rf.unsub(i),lm.delete(i),Fn.clear(),im(Jh,Ma,og),c.remove(),Q?.remove(),Bn("destroy")}i.destroy=qb;function Pf(){Bn("init",n,e),Fa(e||n.data,!1),z[b]?Sf(b,z[b]):Oa(),le=Zt.show&&(Zt.width>0||Zt.height>0),re=ve=!0,V(n.width,n.height)}return _.forEach(xo),M.forEach(Ps),t?t instanceof HTMLElement?(t.appendChild(c),Pf()):t(i,Pf):Pf(),i}$n.assign=An;$n.fmtNum=mm;$n.rangeNum=Zh;$n.rangeLog=ef;$n.rangeAsinh=dm;$n.orient=mo;$n.pxRatio=Nt;$n.join=QC;$n.fmtDate=_m,$n.tzDate=uR;$n.sync=_v;{$n.addGap=XR,$n.clipGaps=sf;let n=$n.paths={points:Mv};n.linear=Tv,n.stepped=jR,n.bars=JR,n.spline=KR}var Pv=12,wm=`${Pv}px system-ui, sans-serif`,c2=[1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4,2e4,5e4,1e5];function u2(n,e){let t=Math.max(...e.map(s=>Math.abs(s??0))),i=t>=1e6||t>0&&t<.001;for(let s=1;;s++){let r=e.map(o=>o===null?"":o===0?"0":i?Number(o.toPrecision(s)).toExponential().replace("e+","e").replaceAll("-","−"):o.toLocaleString("en",{maximumSignificantDigits:s}).replace("-","−"));if(s===15||e.every((o,a)=>o===null||Math.abs(Number(o.toPrecision(s))-o)<=1e-9*t))return r}}function Rv(n,e){if(!e)return 50;n.ctx.save(),n.ctx.font=wm;let t=Math.max(0,...e.map(i=>i?n.ctx.measureText(i).width:0));return n.ctx.restore(),Math.ceil(t)+18}function h2(n,e,t,i){let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=i,s.fillStyle=t,s.font=`${Pv*o}px system-ui, sans-serif`,[s.textAlign,s.textBaseline]=["left","alphabetic"];let a=r.left;for(let{at:l,text:c}of e){let u=n.valToPos(l,"x",!0);if(!(u>=r.left-1&&u<=r.left+r.width+1))continue;s.beginPath(),s.moveTo(u,r.top-4*o),s.lineTo(u,r.top+r.height),s.stroke();let h=s.measureText(c).width,f=Math.max(r.left,Math.min(u,r.left+r.width-h));f<a||(s.fillText(c,f,r.top-8*o),a=f+h+10*o)}s.restore()}function Ia(n){let e=wt(null),t=wt(null),i=wt(n);i.current=n;let s=xs(),r=JSON.stringify([s,n.log,n.series.map(({label:a,color:l,scale:c})=>[a,l,c]),n.height,n.xLabel,n.yLabel]),o=[n.x,...n.series.map(a=>a.values)];return ct(()=>{let a=e.current,{color:l,borderTopColor:c}=getComputedStyle(a),u={stroke:l,grid:{stroke:c,width:1},ticks:{stroke:c,width:1},font:wm,labelFont:wm,labelSize:18,values:u2},h=n.series.some(v=>v.scale==="right"),f=n.bars!==void 0,d=new $n({width:a.clientWidth||300,height:n.height,padding:[n.marks?24:10,h?0:30,0,0],scales:{x:{time:!1,...f?{range:()=>i.current.bars}:{}},y:{distr:n.log?3:1,...f?{range:(v,g,x)=>[0,Math.max(1,x)]}:{}},right:{}},axes:[{...u,label:n.xLabel,size:30},{...u,label:n.yLabel,size:Rv,...f||n.whole?{incrs:c2}:{}},...h?[{...u,label:n.rightLabel,scale:"right",side:1,size:Rv,grid:{show:!1}}]:[]],series:[{label:n.xLabel},...n.series.map(({label:v,color:g,dash:x,width:_,scale:M,points:S})=>({label:v,stroke:g,width:_??1.5,dash:x,scale:M??"y",spanGaps:!1,points:{show:S??!1,size:5},fill:f?g:void 0,paths:f?$n.paths.bars({size:[.9]}):S?()=>null:void 0,value:(T,b)=>b==null?"–":b.toPrecision(4)}))],legend:{show:!f},cursor:{show:!f},hooks:{draw:[v=>h2(v,i.current.marks??[],l,f?l:c)]}},o,a);t.current=d,a.plot=d;let y=new ResizeObserver(()=>d.setSize({width:a.clientWidth,height:n.height}));return y.observe(a),()=>{y.disconnect(),d.destroy()}},[r]),ct(()=>t.current?.setData(o)),p("div",{class:"plot",ref:e,role:"img","aria-label":n.title,"data-points":n.x.length})}function Lv({batch:n}){let e=Math.max(1,n.n_jobs),t=xc.flatMap(i=>n.counts[i]?[{state:i,n:n.counts[i]}]:[]);return p(mt,{children:[p("svg",{class:"counts",viewBox:"0 0 100 6",preserveAspectRatio:"none","aria-hidden":"true",children:t.map(({state:i,n:s},r)=>{let o=t.slice(0,r).reduce((a,l)=>a+l.n,0);return p("rect",{class:i,x:100*o/e,width:100*s/e,height:"6"})})}),p("span",{class:"soft",children:t.map(({state:i,n:s})=>`${s.toLocaleString("en")} ${i}`).join(", ")})]})}function Nv(){let[n,e]=ae([]),[t,i]=ae(),[s,r]=ae(null),[o,a]=ae(!1),l=ki(),c=async(u,h)=>{try{let f=await vt(`v1/batches${Si({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.batches:[...d,...f.batches]),i(f.next_page_token),a(!0)}catch(f){h?.aborted||r(Et(f))}};return Vt(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Jn(5e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),p("div",{children:[p("h1",{children:"Batches"}),p("p",{children:p("a",{class:"button",href:"#/batches/new",children:"New batch from files"})}),p(At,{text:s}),o&&n.length===0&&p("p",{class:"empty",children:["There is no batch yet: one template against many subjects, ",p("a",{href:"#/batches/new",children:"from files"})," or by ",p("code",{children:"POST /v1/batches"})," of ",p("a",{href:"docs/",children:"the API"}),"."]}),n.length>0&&p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Batches",children:p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Batch"}),p("th",{scope:"col",class:"numeric",children:"Jobs"}),p("th",{scope:"col",children:"States"}),p("th",{scope:"col",children:"Tags"}),p("th",{scope:"col",children:"Age"})]})}),p("tbody",{children:n.map(u=>p("tr",{children:[p("td",{children:p("a",{href:`#/batches/${u.id}`,children:u.external_ref??`…${Qn(u.id)}`})}),p("td",{class:"numeric",children:_e(u.n_jobs)}),p("td",{children:p(Lv,{batch:u})}),p("td",{children:Object.entries(u.tags).map(([h,f])=>`${h}:${f}`).join(", ")}),p("td",{children:_s(u.created_at,l)})]},u.id))})]})}),t!==void 0&&p("button",{onClick:()=>{c(t)},children:"More"})]})}var lf=[{name:"Mean distance, mm",of:n=>n.surface_distance?.mean_mm},{name:"95 % within, mm",of:n=>n.surface_distance?.p95_mm},{name:"Largest distance, mm",of:n=>n.surface_distance?.max_mm}];function Iv(n){return Kn(n.state)?n.state!=="succeeded"?2e9:(n.reliable===!1?1e9:0)+(n.surface_distance?.p95_mm??0):-1}function Dv({id:n}){let[e,t]=ae(null),[i,s]=ae([]),[r,o]=ae(null),[a,l]=ae(0);if(Vt(v=>{(async()=>{try{let g="";for(;!v.aborted;){let x=await vt(`v1/batches/${n}${g}`,v);t(x);let _=[],M="";for(;M!==void 0;){let S=await vt(`v1/batches/${n}/jobs${Si({page_size:500,page_token:M})}`,v);_.push(...S.jobs.map($h)),M=S.next_page_token}if(s(_),x.finished)return;g="?wait=20",await Jn(500,v)}}catch(g){v.aborted||o(Et(g))}})()},[n]),e===null)return r===null?p("p",{class:"loading",children:"Loading the batch …"}):p(At,{text:r});let c=lf[a-1],u=[...i].sort((v,g)=>c?(c.of(g)??-1)-(c.of(v)??-1):Iv(g)-Iv(v)),h=i.filter(v=>v.state==="succeeded"),f=h.filter(v=>v.reliable===!1).length,d=i.filter(v=>Kn(v.state)&&v.state!=="succeeded").length,y=d+f>0?"bad":e.finished?"good":"wait";return p("article",{children:[p("h1",{class:"sub",children:["Batch ",e.external_ref??p("code",{children:n})]}),p("section",{class:`verdict ${y}`,"aria-label":"Verdict",children:[p("span",{class:"mark","aria-hidden":"true",children:y==="good"?"✓":y==="bad"?"✕":"…"}),p("div",{children:[p("p",{class:"title",children:d+f>0?`${d+f} of ${_e(e.n_jobs)} ${d+f===1?"needs":"need"} a look`:e.finished?"All reliable, or not checked":"Running"}),p("p",{children:[f," not reliable, ",d," without a result, ",h.length-f," others succeeded."]}),p(Lv,{batch:e})]}),p("div",{class:"actions",children:!e.finished&&p("button",{onClick:()=>Vn("POST",`v1/batches/${n}/cancel`).catch(v=>o(Et(v))),children:"Cancel the rest"})})]}),p(At,{text:r}),p("div",{class:"columns three",children:lf.map(({name:v,of:g})=>p(d2,{name:v,values:h.flatMap(x=>g(x)??[])},v))}),p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Subject"}),p("th",{scope:"col",children:"State"}),p("th",{scope:"col","aria-sort":a===0?"descending":void 0,children:p("button",{class:"plain",onClick:()=>l(0),children:"Verdict, worst first"})}),lf.map(({name:v},g)=>p("th",{scope:"col",class:"numeric","aria-sort":a===g+1?"descending":void 0,children:p("button",{class:"plain",onClick:()=>l(g+1),children:v})},v)),p("th",{scope:"col",children:"Ran for"})]})}),p("tbody",{children:u.slice(0,500).map(v=>{let g=Sc(v);return p("tr",{children:[p("td",{children:p("a",{href:`#/jobs/${v.id}`,children:v.external_ref??`…${Qn(v.id)}`})}),p("td",{children:p(Lo,{state:v.state})}),p("td",{children:g.text!==""&&p(hn,{tone:g.tone,children:g.text})}),lf.map(({name:x,of:_})=>p("td",{class:"numeric",children:Mi(_(v))},x)),p("td",{children:v.started_at&&v.finished_at?Bi(Date.parse(v.finished_at)-Date.parse(v.started_at)):""})]},v.id)})})]})}),u.length>500&&p("p",{children:["The first 500 of ",_e(u.length),". ",p("a",{href:`#/jobs?batch=${n}`,children:"All of them"})]})]})}var Kl=16;function f2(n){let[e,t]=[Math.min(...n),Math.max(...n)],i=(t-e||Math.abs(t)*.1||1)/(Kl-1),s=t>e?[e-i/2,t+i/2]:[e-Kl*i/2,e+Kl*i/2],r=Array.from({length:Kl},()=>null);for(let o of n){let a=Math.min(Kl-1,Math.max(0,Math.floor((o-s[0])/i)));r[a]=(r[a]??0)+1}return{range:s,middles:r.map((o,a)=>s[0]+(a+.5)*i),counts:r}}function d2({name:n,values:e}){if(e.length===0)return null;let{range:t,middles:i,counts:s}=f2(e),r=[...e].sort((a,l)=>a-l)[Math.floor(e.length/2)],o=`median ${_e(r)}`;return p("section",{class:"card",children:[p("h2",{children:n}),p(Ia,{title:`${n}: ${e.length} matches, ${o}`,x:i,series:[{label:"matches",color:"#2f7ebc",values:s}],height:190,xLabel:n,yLabel:"matches",bars:t,marks:[{at:r,text:o}]})]})}var Tm=n=>n.method==="study_score";function Fv({job:n}){let[e,t]=ae(null),[i,s]=ae(null),r=n.links.score?.slice(1);if(Vt(a=>{r!==void 0&&ri(()=>vt(r,a),a).then(l=>!a.aborted&&t(l),l=>!a.aborted&&s(Et(l)))},[r]),i!==null)return p(At,{text:i});if(e===null)return p("p",{class:"loading",children:"Loading the score …"});let o=e.reliable===null?"not checked":e.reliable?"reliable":`not reliable: ${e.reasons.map(It).join(", ")}`;return p("section",{class:"card","aria-label":"Score",children:[p("h2",{children:"Against the group"}),p(Rn,{rows:[["Compared with",`${_e(e.members)} members${e.within?` with ${e.within.covariate} ${e.within.level}`:""}`],["Match with the template",o],["p of a shape as unusual",e.unusual_p.toFixed(3)],["Largest score, in standard deviations",`${e.largest_score.toFixed(2)} (p ${e.largest_score_p.toFixed(3)})`],[`Bound of the screening, at ${e.bound.level}`,e.bound.score.toFixed(2)],["Regions beyond the bound",_e(e.regions.length)]]}),e.regions.length>0&&p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"area, mm²"}),p("th",{scope:"col",children:"vertices"}),p("th",{scope:"col",children:"largest score"}),p("th",{scope:"col",children:"deviation there, mm"}),p("th",{scope:"col",children:"place, mm"})]})}),p("tbody",{children:e.regions.map(a=>p("tr",{children:[p("td",{children:a.area_mm2.toFixed(1)}),p("td",{children:_e(a.vertices)}),p("td",{children:a.score.toFixed(2)}),p("td",{children:a.deviation_mm.toFixed(2)}),p("td",{children:a.peak_mm.map(l=>l.toFixed(1)).join(", ")})]}))})]})]})}var Ql=1<<30,cf={2:[1,(n,e)=>n.getUint8(e)],256:[1,(n,e)=>n.getInt8(e)],4:[2,(n,e,t)=>n.getInt16(e,t)],512:[2,(n,e,t)=>n.getUint16(e,t)],8:[4,(n,e,t)=>n.getInt32(e,t)],768:[4,(n,e,t)=>n.getUint32(e,t)],16:[4,(n,e,t)=>n.getFloat32(e,t)],64:[8,(n,e,t)=>n.getFloat64(e,t)],1024:[8,(n,e,t)=>Number(n.getBigInt64(e,t))],1280:[8,(n,e,t)=>Number(n.getBigUint64(e,t))]},uf=class{constructor(e){this.view=e;let t=[!0,!1].map(s=>e.getInt32(0,s)),i=t.findIndex(s=>s===348||s===540);if(i<0)throw new Error("This is no volume of NIfTI, NRRD, MetaImage or MGH.");this.little=i===0,this.second=t[i]===540}view;little;second;integer(e,t,i){return this.second?i===8?Number(this.view.getBigInt64(t,this.little)):i===4?this.view.getInt32(t,this.little):this.view.getInt16(t,this.little):i===2||i===8?this.view.getInt16(e,this.little):this.view.getInt32(e,this.little)}real(e,t,i=0){return this.second?this.view.getFloat64(t+8*i,this.little):this.view.getFloat32(e+4*i,this.little)}get dims(){let e=i=>Math.max(1,this.integer(40+2*i,16+8*i,8)),t=this.integer(40,16,8);return[1,2,3].map(i=>i<=t?e(i):1)}get kind(){return this.integer(70,12,2)}get offset(){return this.second?Number(this.view.getBigInt64(168,this.little)):Math.round(this.view.getFloat32(108,this.little))}get worldFromVoxel(){let e=(r,o)=>this.second?this.view.getInt32(o,this.little):this.view.getInt16(r,this.little),t=[1,1e3,1,.001][(this.second?this.view.getInt32(500,this.little):this.view.getUint8(123))&7]??1,i=[1,2,3].map(r=>Math.abs(this.real(76,104,r))),s=new Je;if(e(254,348)>0){let r=Array.from({length:12},(a,l)=>this.real(280,400,l));s.set(...r).setPosition(r[3],r[7],r[11]);let o=s.elements;[o[3],o[7],o[11],o[15]]=[0,0,0,1]}else if(e(252,344)>0){let[r,o,a]=[0,1,2].map(u=>this.real(256,352,u)),l=new fn(r,o,a,Math.sqrt(Math.max(0,1-r*r-o*o-a*a))).normalize(),c=new H(...[0,1,2].map(u=>this.real(268,376,u)));s.compose(c,l,new H(i[0],i[1],i[2]*(this.real(76,104)<0?-1:1)))}else s.makeScale(i[0],i[1],i[2]);return new Je().makeScale(t,t,t).multiply(s)}};async function p2(n,e){let t=new Uint8Array(await n.slice(0,2).arrayBuffer()),s=(t[0]===31&&t[1]===139?n.stream().pipeThrough(new DecompressionStream("gzip")):n.stream()).getReader(),[r,o,a]=[new Uint8Array(65536),0,1/0];for(;;){let{done:l,value:c}=await s.read();if(c){if(o+c.length>r.length){let u=new Uint8Array(Math.min(Math.max(2*r.length,o+c.length),Math.max(a,o+c.length)));u.set(r.subarray(0,o)),r=u}r.set(c,o),o+=c.length}if(a===1/0&&o>=544&&(a=e(new DataView(r.buffer,0,o))),l||o>=a)break}if(await s.cancel(),o<(a===1/0?352:a))throw new Error("This NIfTI file ends too early.");return new DataView(r.buffer,0,o)}async function Ov(n){let e=v=>{let g=new uf(v),x=cf[g.kind];if(!x)throw new Error("This NIfTI file has voxels of a kind that is not shown: numbers of up to 64 bits are.");let _=g.offset+g.dims[0]*g.dims[1]*g.dims[2]*x[0];if(!(_<=Ql))throw new Error("This volume is too large to be shown: at most 1 GiB is.");return _},t=await p2(n,e);e(t);let i=new uf(t),[s,r]=cf[i.kind],{dims:o,offset:a,little:l}=i,c=o[0]*o[1]*o[2],[u,h]=[i.real(112,176),i.real(116,184)],[f,d]=u!==0&&Number.isFinite(u)&&Number.isFinite(h)?[u,h]:[1,0],y=new Float32Array(c);for(let v=0;v<c;v++)y[v]=f*r(t,a+v*s,l)+d;return ec(o,y,i.worldFromVoxel)}function ec(n,e,t){let i=Math.max(1,Math.floor(e.length/1e5)),s=e.filter((a,l)=>l%i===0&&Number.isFinite(a)).sort(),[r,o]=[.01,.99].map(a=>s[Math.floor(a*(s.length-1))]??0);return r===o&&([r,o]=[s[0]??0,e.reduce((a,l)=>Math.max(a,l),r)]),{dims:n,values:e,worldFromVoxel:t,low:r,high:o>r?o:r+1}}function Uv({dims:n,values:e},t,i){let s=i.clone().applyMatrix4(t).round().toArray();if(!s.some((r,o)=>r<0||r>=n[o]))return{voxel:s,value:e[s[0]+n[0]*(s[1]+n[1]*s[2])]}}var Bv=2048,Vv="This volume is too large to be shown: at most 1 GiB is.",Gv=new Je().makeScale(-1,-1,1),[Cm,Hv,Rm,Pm,hf,Am,Im,Wv,$v,Xv]=[2,256,4,512,8,768,16,64,1024,1280].map(n=>cf[n]);async function Em(n,e,t=1/0){let i=n.getReader(),s=[],r=0;for(;;){let{done:l,value:c}=await i.read();if(l)break;if(s.push(c),r+=c.length,r>e)throw new Error(Vv);if(r>=t)break}i.cancel().catch(()=>{});let o=new Uint8Array(r),a=0;for(let l of s)o.set(l,a),a+=l.length;return o}async function kv(n){let e=new Uint8Array(await n.slice(0,2).arrayBuffer());return e[0]===31&&e[1]===139?n.stream().pipeThrough(new DecompressionStream("gzip")):n.stream()}async function Lm(n,e,t,i,s=!1){let o=t===null?n:await Em((a=>new Blob([n]).stream().pipeThrough(new DecompressionStream(a)))(t),s?2*Ql:1/0,s?1/0:e);if(o.length<e)throw new Error(`This ${i} file ends too early.`);return o}function Nm(n,e,[t,i],s,r=1,o=0){let a=new DataView(n.buffer,n.byteOffset,n.byteLength),l=new Float32Array(e[0]*e[1]*e[2]);for(let c=0;c<l.length;c++)l[c]=r*i(a,c*t,s)+o;return l}function Dm(n,[e]){let t=e*n.reduce((i,s)=>i*s,1);if(!(t<=Ql))throw new Error(Vv);return t}function qv(n,e,t){let[i,s]=[new TextDecoder,[]];for(let r=0;s.length<1e5;){let o=n.indexOf(10,r);if(o<0)break;let a=i.decode(n.subarray(r,o)).replace(/\r$/,"");if(r=o+1,s.push(a),e(a))return{lines:s,end:r}}throw new Error(`This ${t} file ends within its header.`)}var m2=n=>n?.trim().split(/\s+/).filter(Boolean)??[],ff=n=>m2(n).map(Number);function Yv(n){let e={nm:1e-6,um:.001,µm:.001,micron:.001,microns:.001,mm:1,cm:10,dm:100,m:1e3,in:25.4,ft:304.8},t={nano:1e-6,micro:.001,milli:1,centi:10,deci:100,"":1e3},i=n?.replace(/^["'\s]+|["'\s]+$/g,"").toLowerCase()??"",s=/^(nano|micro|milli|centi|deci|)met(er|re)s?$/.exec(i)?.[1];return e[i]??(s===void 0?1:t[s])}function jv(n,e){let t=n.map((i,s)=>s);for(;t.length>3;){let i=t.map(s=>n[s]).lastIndexOf(1);if(i<0)break;t.splice(i,1)}if(t.length!==3||!n.every(i=>Number.isInteger(i)&&i>0))throw new Error(`This ${e} file has not three dimensions: one volume is shown, without layers.`);return t}var g2=[[/^(signed char|int8(_t)?)$/,Hv],[/^(uchar|unsigned char|uint8(_t)?)$/,Cm],[/^((signed )?short( int)?|int16(_t)?)$/,Rm],[/^(ushort|unsigned short( int)?|uint16(_t)?)$/,Pm],[/^((signed )?int|int32(_t)?)$/,hf],[/^(uint|unsigned int|uint32(_t)?)$/,Am],[/^((signed )?long ?long( int)?|int64(_t)?)$/,$v],[/^(ulonglong|unsigned long long( int)?|uint64(_t)?)$/,Xv],[/^float$/,Im],[/^double$/,Wv]];async function _2(n){let{lines:e,end:t}=qv(n,C=>C==="","NRRD"),i=new Map(e.slice(1).flatMap(C=>{let I=/^([^#:=]+):(?!=)\s*(.*)$/.exec(C);return I?[[I[1].trim().toLowerCase().replace(/^(data|line|byte)(file|skip)$/,"$1 $2"),I[2].trim()]]:[]}));if(i.has("data file"))throw new Error("The voxels of this NRRD header are in another file: header and voxels in one .nrrd file are shown.");let s=g2.find(([C])=>C.test(i.get("type")??""))?.[1];if(!s)throw new Error("This NRRD file has voxels of a kind that is not shown: integers and real numbers are.");let r=ff(i.get("sizes")),o=jv(r,"NRRD"),a=o.map(C=>r[C]),l=Dm(a,s),c=i.get("encoding")?.toLowerCase()??"";if(!["raw","gzip","gz"].includes(c))throw new Error("This NRRD file has an encoding that is not shown: raw and gzip are.");let u=n.subarray(t);for(let C=Number(i.get("line skip")??0);C>0;C--)u=u.subarray(u.indexOf(10)+1);let h=Number(i.get("byte skip")??0),f=c==="raw"?null:u[0]===31&&u[1]===139?"gzip":"deflate",d=await Lm(u,h<0?l-h-1:l+h,f,"NRRD",h<0),y=d.subarray(h<0?d.length-l+h+1:h),v=[...(i.get("space directions")??"").matchAll(/none|\(([^)]*)\)/g)].map(C=>C[1]?.split(",").map(Number)),g=ff(i.get("spacings")),x=C=>{let[I,E]=[o[C],v[o[C]]];if(E)return new H(...E);let F=g[I];return new H().setComponent(C,F>0?F:1)},_=new Je().makeBasis(x(0),x(1),x(2)),M=/\(([^)]*)\)/.exec(i.get("space origin")??"")?.[1]?.split(",").map(Number);M?.length===3&&_.setPosition(M[0],M[1],M[2]);let S=C=>[...(i.get(C)??"").matchAll(/"([^"]*)"|(\S+)/g)].map(I=>I[1]??I[2]),T=v.length>0||!i.has("units")?S("space units"):o.map(C=>S("units")[C]??""),[b,m,w]=[0,1,2].map(C=>Yv(T[C]));_.premultiply(new Je().makeScale(b,m,w));let R=(i.get("space")??"").toLowerCase();return["left-posterior-superior","lps"].includes(R)?_.premultiply(Gv):["left-anterior-superior","las"].includes(R)&&_.premultiply(new Je().makeScale(-1,1,1)),ec(a,Nm(y,a,s,i.get("endian")?.toLowerCase()!=="big"),_)}var x2={MET_CHAR:Hv,MET_UCHAR:Cm,MET_SHORT:Rm,MET_USHORT:Pm,MET_INT:hf,MET_LONG:hf,MET_UINT:Am,MET_ULONG:Am,MET_LONG_LONG:$v,MET_ULONG_LONG:Xv,MET_FLOAT:Im,MET_DOUBLE:Wv};async function y2(n){let{lines:e,end:t}=qv(n,m=>/^\s*ElementDataFile\s*[=:]/.test(m),"MetaImage"),i=new Map(e.map(m=>m.split(/[=:](.*)/s).map(w=>w.trim())));if(i.get("ElementDataFile")?.toUpperCase()!=="LOCAL")throw new Error("The voxels of this MetaImage header are in another file: header and voxels in one .mha file are shown.");let s=x2[i.get("ElementType")??""];if(!s||!["1",void 0].includes(i.get("ElementNumberOfChannels"))||i.get("BinaryData")?.toLowerCase()==="false")throw new Error("This MetaImage file has voxels of a kind that is not shown: binary integers and real numbers of one channel are.");let r=ff(i.get("DimSize")),o=jv(r,"MetaImage"),a=o.map(m=>r[m]),l=Dm(a,s),c=(...m)=>m.some(w=>i.get(w)?.toLowerCase()==="true"),u=Number(i.get("HeaderSize")??0),h=c("CompressedData")?t:u<0?Math.max(t,n.length-l):Math.max(t,u),f=await Lm(n.subarray(h),l,c("CompressedData")?"deflate":null,"MetaImage"),d=(m,w)=>m.map(R=>ff(i.get(R))).find(R=>R.length===w),y=d(["TransformMatrix","Rotation","Orientation"],r.length**2),v=d(["ElementSpacing","ElementSize"],r.length),g=d(["Offset","Position","Origin"],r.length),x=m=>{let w=y?o.map(R=>y[o[m]*r.length+R]):[0,1,2].map(R=>+(R===m));return new H(...w).multiplyScalar(v?.[o[m]]??1)},_=new Je().makeBasis(x(0),x(1),x(2));g&&_.setPosition(...o.map(m=>g[m]));let M=Yv(i.get("DistanceUnits"));_.premultiply(new Je().makeScale(M,M,M)).premultiply(Gv);let S=(m,w)=>i.has(m)?Number(i.get(m)):w,[T,b]=[S("ElementToIntensityFunctionSlope",1),S("ElementToIntensityFunctionOffset",0)];return ec(a,Nm(f,a,s,!c("BinaryDataByteOrderMSB","ElementByteOrderMSB"),T,b),_)}var zv=284,v2={0:Cm,1:hf,3:Im,4:Rm,10:Pm};function b2(n){if(n.byteLength<24)return!1;let[e,...t]=Array.from({length:6},(s,r)=>n.getInt32(4*r)),i=t.pop();return(e&255)===1&&e>0&&e<65536&&t.every(s=>s>=1&&s<=1<<20)&&i>=0&&i<=11}async function S2(n){let e=new DataView(n.buffer,n.byteOffset,n.byteLength),t=v2[e.getInt32(20)];if(!t||e.getInt32(16)!==1)throw new Error("This MGH file has voxels of a kind that is not shown: one frame of integers or real numbers is.");let i=[4,8,12].map(u=>e.getInt32(u)),s=(await Lm(n,zv+Dm(i,t),null,"MGH")).subarray(zv),o=e.getInt16(28)>0?Array.from({length:15},(u,h)=>e.getFloat32(30+4*h)):[1,1,1,-1,0,0,0,0,-1,0,1,0,0,0,0],a=u=>new H(o[3+3*u],o[4+3*u],o[5+3*u]).multiplyScalar(o[u]),l=new Je().makeBasis(a(0),a(1),a(2)),c=new H(...i).divideScalar(2).applyMatrix4(l);return ec(i,Nm(s,i,t,!1),l.setPosition(new H(o[12],o[13],o[14]).sub(c)))}async function Jv(n){let e=await Em(await kv(n),1/0,Bv),t=new TextDecoder("latin1").decode(e.subarray(0,Bv)),i=async()=>Em(await kv(n),2*Ql);if(t.startsWith("NRRD000"))return _2(await i());if(/^\s*\w+\s*=/.test(t)&&/^\s*(NDims|DimSize|ElementType)\s*[=:]/m.test(t))return y2(await i());if(t.slice(128,132)==="DICM")throw new Error("DICOM files of yours are not shown: convert the series to NIfTI, for example with dcm2niix.");return b2(new DataView(e.buffer,0,e.length))?S2(await i()):Ov(n)}var M2=[{name:"Sagittal",across:0,right:1,up:2},{name:"Coronal",across:1,right:0,up:2},{name:"Axial",across:2,right:0,up:1}],Zv=["LR","PA","IS"],Fm={target:"#e69f00",source:"#56b4e9"},w2=10,T2=8<<20;function A2(n,e,t,i){let[s,r]=[e.min.toArray(),e.max.toArray()],[o,a]=[r[n.right]-s[n.right],r[n.up]-s[n.up]],l=Math.min(t/o,i/a);return{left:(s[n.right]+r[n.right])/2-t/2/l,low:(s[n.up]+r[n.up])/2-i/2/l,scale:l}}function E2(n,e,t,i,s,r,o){let a=new ImageData(r,o),l=(g,x)=>{let _=[0,0,0];return _[t.across]=i,_[t.right]=s.left+(g+.5)/s.scale,_[t.up]=s.low+(o-x-.5)/s.scale,new H(..._).applyMatrix4(e)},c=l(0,0),[u,h]=[l(1,0).sub(c),l(0,1).sub(c)],[f,d,y]=n.dims,v=255/(n.high-n.low);for(let g=0;g<o;g++)for(let x=0;x<r;x++){let _=Math.round(c.x+x*u.x+g*h.x),M=Math.round(c.y+x*u.y+g*h.y),S=Math.round(c.z+x*u.z+g*h.z);if(_<0||M<0||S<0||_>=f||M>=d||S>=y)continue;let T=Math.max(0,Math.min(255,(n.values[_+f*(M+d*S)]-n.low)*v)),b=4*(g*r+x);a.data[b]=a.data[b+1]=a.data[b+2]=T,a.data[b+3]=255}return a}function C2(n,e,t,i,s,r){n.beginPath();for(let o=0;o<t.length;o+=3){let a=[];for(let l=0;l<3;l++){let[c,u]=[3*t[o+l],3*t[o+(l+1)%3]],[h,f]=[e[c+i.across]-s,e[u+i.across]-s];if(h<0==f<0)continue;let d=h/(h-f),y=v=>e[c+v]+d*(e[u+v]-e[c+v]);a.push(r(y(i.right),y(i.up)))}a.length===2&&(n.moveTo(...a[0]),n.lineTo(...a[1]))}n.stroke()}function R2({plane:n,volume:e,voxelFromWorld:t,box:i,outlines:s,point:r,step:o,move:a}){let l=wt(null),[c,u]=ae(0),h=xs(),f=r.getComponent(n.across),[d,y]=[r.getComponent(n.right),r.getComponent(n.up)];ct(()=>{let S=new ResizeObserver(()=>u(l.current?.clientWidth??0));return S.observe(l.current),()=>S.disconnect()},[]);let v=Qt(()=>c>0?A2(n,i,c,c):null,[n,i,c]),g=Qt(()=>v&&E2(e,t,n,f,v,c,c),[e,n,f,v]);ct(()=>{if(!v||!g)return;let S=l.current,T=Math.min(2,devicePixelRatio);S.width=S.height=c*T;let b=S.getContext("2d");b.scale(T,T);let m=document.createElement("canvas");m.width=m.height=c,m.getContext("2d").putImageData(g,0,0),b.imageSmoothingEnabled=!1,b.drawImage(m,0,0,c,c);let w=(z,X)=>[(z-v.left)*v.scale,c-(X-v.low)*v.scale];S.project=z=>w(z[n.right],z[n.up]),b.lineWidth=2;for(let{positions:z,index:X,color:k}of s)b.strokeStyle=k,C2(b,z,X,n,f,w);let[R,C]=w(d,y);b.strokeStyle="#ff2d95",b.lineWidth=1,b.beginPath();for(let[z,X]of[[1,0],[-1,0],[0,1],[0,-1]])b.moveTo(R+6*z,C+6*X),b.lineTo(R+2*c*z,C+2*c*X);b.stroke(),b.font="600 13px system-ui, sans-serif",b.textBaseline="middle";let[I,E,F,D]=[...Zv[n.right],...Zv[n.up]];for(let[z,X,k]of[[I,12,c/2],[E,c-12,c/2],[D,c/2,12],[F,c/2,c-12]])b.textAlign="center",b.lineWidth=3,b.strokeStyle="#000000",b.strokeText(z,X,k),b.fillStyle="#ffffff",b.fillText(z,X,k)},[g,s,d,y,h]);let x=S=>{let T=r.clone();for(let b of["across","right","up"])S[b]!==void 0&&T.setComponent(n[b],S[b]);a(T)},_=S=>{if(S.buttons!==1||!v)return;let T=l.current.getBoundingClientRect();x({right:v.left+(S.clientX-T.left)/v.scale,up:v.low+(T.height-(S.clientY-T.top))/v.scale})},M=S=>{let b={ArrowLeft:{right:d-o},ArrowRight:{right:d+o},ArrowUp:{up:y+o},ArrowDown:{up:y-o},PageUp:{across:f+o},PageDown:{across:f-o}}[S.key];b&&(S.preventDefault(),x(b))};return p("figure",{class:"slice",children:[p("canvas",{ref:l,tabIndex:0,role:"img","aria-label":`${n.name} slice with the outlines of both surfaces. Arrow keys move the crosshair, Page Up and Page Down go to other slices.`,"data-plane":n.name,onPointerDown:S=>{l.current.setPointerCapture(S.pointerId),_(S)},onPointerMove:_,onWheel:S=>{S.preventDefault(),x({across:f-Math.sign(S.deltaY)*o})},onKeyDown:M}),p("figcaption",{children:n.name})]})}var P2=n=>!!n.report.sampling;function Kv({job:n,pair:e,cross:t,setCross:i}){let s=["target","source"].filter(m=>P2(n[m])),[r,o]=ae(s.find(m=>n[m].n_bytes<=T2)??null),[a,l]=ae(null),[c,u]=ae(null),[h,f]=ae(!1),[d,y]=ae(null);Vt(m=>{if(u(null),y(null),r===null||r==="own"&&a===null)return;(r==="own"?Promise.resolve(a):Mn(`v1/jobs/${n.id}/volumes/${r}`,{signal:m}).then(R=>R.blob())).then(Jv).then(R=>!m.aborted&&u(R),R=>{m.aborted||y(R instanceof zn?Et(R):R instanceof Error?R.message:String(R))})},[r,a]);let v=Qt(()=>r==="source"?e.targetFromSource.clone().invert():new Je,[r,e]),g=Qt(()=>{let m=(R,C,I)=>{let E=R.getAttribute("position"),F=new Float32Array(3*E.count),D=new H;for(let z=0;z<E.count;z++)D.fromBufferAttribute(E,z).applyMatrix4(C).toArray(F,3*z);return{positions:F,index:R.getIndex().array,color:I}},w=v.clone().multiply(e.targetFromSource);return[m(e.target,v,Fm.target),m(e.source,w,Fm.source)]},[v,e]),x=Qt(()=>c?.worldFromVoxel.clone().invert()??new Je,[c]),_=Qt(()=>{let m=new Pi;if(h&&c){for(let w=0;w<8;w++)m.expandByPoint(new H(...c.dims.map((R,C)=>w>>C&1?R-.5:-.5)).applyMatrix4(c.worldFromVoxel));return m}for(let{positions:w}of g)m.union(new Pi().setFromArray(w));return m.expandByScalar(w2)},[g,h,c]),M=Qt(()=>{let m=[0,1,2].map(w=>new H().setFromMatrixColumn(c?.worldFromVoxel??new Je,w).length());return Math.min(...m)||1},[c]),S=(t??e.frame.center).clone().applyMatrix4(v),T=c&&Uv(c,x,S),b=n.target.report.space;return p("section",{class:"card section","aria-label":"Slices",children:[p("h2",{children:"Slices of a volume"}),p("div",{class:"tools",children:[s.map(m=>p("label",{class:"check",children:[p("input",{type:"radio",name:"volume",checked:r===m,onChange:()=>o(m)})," the ",m,"'s label volume"]})),p("label",{class:"button",children:[a===null?"A file of yours …":a.name,p("input",{class:"quiet",type:"file","aria-label":"A volume of yours: NIfTI, NRRD, MetaImage or MGH",onChange:m=>{let w=m.currentTarget.files?.[0];w&&(l(w),o("own"))}})]}),c&&p(qn,{label:"Whole volume",checked:h,onChange:m=>f(m.currentTarget.checked)}),p("ul",{class:"categories",children:["target","source"].map(m=>p("li",{children:[p("svg",{width:"16",height:"12","aria-hidden":"true",children:p("rect",{y:"4",width:"16",height:"4",fill:Fm[m]})})," ",m,m==="source"&&", aligned"]}))})]}),p(At,{text:d}),r===null&&p("p",{class:"hint",children:"A volume in the space of the target (NIfTI, NRRD, MetaImage, MGH), such as the image that it was segmented from, is shown under both surfaces. The file stays in this browser."}),r==="own"&&b!=="scanner_ras"&&c&&p("p",{class:"hint",children:["The target's file declares ",b===void 0||b==="unknown"?"no space":`the space ${b.replaceAll("_"," ")}`,": the volume fits only if its coordinates are the same."]}),r!==null&&c===null&&d===null&&p("p",{class:"loading",children:"Loading the volume …"}),c&&p(mt,{children:[p("div",{class:"slices",children:M2.map(m=>p(R2,{plane:m,volume:c,voxelFromWorld:x,box:_,outlines:g,point:S,step:M,move:w=>i(w.applyMatrix4(v.clone().invert()))},m.name))}),p("output",{class:"readout","aria-live":"off",id:"crosshair",children:["R ",S.x.toFixed(1),", A ",S.y.toFixed(1),", S ",S.z.toFixed(1)," mm · ",T?`voxel ${T.voxel.join(", ")} · value ${_e(T.value)}`:"outside of the volume",p("span",{class:"hint",children:" · Press on a slice, or on a surface above, to move the crosshair; scroll for other slices."})]})]})]})}var Qv=4e3;function I2(n){if(n.length<=Qv)return n;let e=Math.ceil(2*n.length/Qv),t=[];for(let i=0;i<n.length;i+=e){let s=Math.min(n.length,i+e),[r,o]=[i,i];for(let a=i+1;a<s;a++){let l=n[a].energy;l!==void 0&&(l>=(n[r].energy??1/0)||(r=a),l<=(n[o].energy??-1/0)||(o=a))}for(let a=i;a<s;a++){let l=n[a],c=a===0||gs(l)!==gs(n[a-1]);(a===r||a===o||a===n.length-1||l.support!==void 0||c)&&t.push(l)}}return t}var eb={field_energy:{name:"the displacement field",unary:"misfit",pairwise:"deformation",help:"Energy of the displacement field for each independent observation. Every fit begins anew, and a fit estimates its own scale at every step, so that its energy may rise while the surfaces come closer."},isometry_energy:{name:"distances along the surfaces",unary:"unary",pairwise:"pairwise",help:"Energy of the assignment of target vertices over distances along the surfaces. Belief propagation does not lower it at every point; the phase registration does."},mean_isometry_energy:{name:"distances along the surfaces, for each variable",unary:"unary",pairwise:"pairwise",help:"Energy of the assignment of target vertices over distances along the surfaces, divided by the number of variables: a point for each assignment from which a field begins."},curvature_energy:{name:"curvature",unary:"unary",pairwise:"pairwise",help:"Energy of the assignment of target vertices over curvature. Belief propagation and random sweeps do not lower it at every point, and every round begins anew."}},tb=n=>eb[n]??{...eb.curvature_energy,name:It(n),help:"Values of this quantity are compared within one line only."},tc=({start:n,round:e,phase:t,chosen:i})=>`${n===void 0?"":`start ${n}, `}${t==="displacement"?"fit":"round"} ${e}${i?", chosen":""}`;function nb({points:n,isLive:e}){let[t,i]=ae(!1),[s,r]=ae(!1),[o,a]=ae("all"),[l,c]=ae(null),u=Qt(()=>n.filter(E=>E.energy!==void 0||E.support!==void 0),[n]),h=Qt(()=>[...new Set(u.map(yc))],[u]),f=l!==null&&h.includes(l)?l:h.at(-1)??"curvature_energy",d=tb(f),y=Qt(()=>u.filter(E=>yc(E)===f),[u,f]),v=Qt(()=>[...new Set(y.map(E=>tc({...E,chosen:!1})))],[y]),g=v.includes(o),x=Qt(()=>y.filter(E=>!g||tc({...E,chosen:!1})===o),[y,g,o]),_=Qt(()=>I2(x),[x]),M=_.flatMap((E,F)=>F>0&&gs(_[F-1])!==gs(E)?[null,E]:[E]),S=M.map((E,F)=>E?.seq??M[F+1].seq-.5),T=E=>M.map(F=>{if(F===null)return null;let D=F[E];return D===void 0||t&&E!=="support"&&D<=0?void 0:D}),b=E=>_.some(F=>F[E]!==void 0),m=_.flatMap((E,F)=>{let D=tc(E);return F===0||tc(_[F-1])!==D?[{at:E.seq,text:D}]:[]}),w=E=>_[E].energy!==void 0&&[_[E-1],_[E+1]].every(F=>F===void 0||gs(F)!==gs(_[E])),R=new Set(_.filter((E,F)=>w(F))),C=x.at(-1),I=[{label:"energy",color:"#0072b2",values:T("energy"),width:2.5},...R.size>0?[{label:"energy, single points",color:"#0072b2",values:M.map(E=>E!==null&&R.has(E)?E.energy:void 0),points:!0}]:[],...s?[{label:d.unary,color:"#d55e00",values:T("energy_unary"),dash:[6,3]},{label:d.pairwise,color:"#009e73",values:T("energy_pairwise"),dash:[2,3]}]:[],...b("lower_bound")?[{label:"lower bound",color:"#8c6d1f",values:T("lower_bound"),dash:[10,4]}]:[],...b("temperature")?[{label:"temperature",color:"#cc79a7",values:T("temperature"),scale:"right"}]:[],...b("support")&&!b("temperature")?[{label:"support (inliers)",color:"#b0607f",values:T("support"),scale:"right",points:!0}]:[]];return p("section",{class:"card wide",id:"trace","data-points":n.length,"data-last":n.at(-1)?.seq??0,children:[p("h2",{children:["Energy ",e&&p(hn,{tone:"wait",children:"live"})]}),p("div",{class:"tools",children:[p(qn,{label:"Logarithmic",checked:t,onChange:E=>i(E.currentTarget.checked)}),p(qn,{label:"Its parts",checked:s,onChange:E=>r(E.currentTarget.checked)}),h.length>1&&p("label",{children:["Of"," ",p("select",{value:f,onChange:E=>c(E.currentTarget.value),children:h.map(E=>p("option",{value:E,children:tb(E).name}))})]}),v.length>1&&p("label",{children:["Show"," ",p("select",{value:g?o:"all",onChange:E=>a(E.currentTarget.value),children:[p("option",{value:"all",children:"all"}),v.map(E=>p("option",{value:E,children:E}))]})]}),C&&p("span",{children:[_e(n.length)," points · latest ",_e(C.energy??null)," in ",It(C.phase),", ",tc(C),", iteration ",C.iteration]})]}),_.length===0?p("p",{class:"hint",children:e?"The first point comes with the first iteration.":"This method minimizes no energy, or its trace has been removed."}):p(mt,{children:[p(Ia,{title:`Energy of ${d.name} over ${n.length} points, the last one ${_e(C?.energy??null)}`,x:S,series:I,log:t,height:280,xLabel:"point of the trace",yLabel:"energy",rightLabel:b("temperature")?"temperature":"inliers",marks:m}),p("p",{class:"soft",children:[d.help," Lines are not joined where values cannot be compared."]})]})]})}var L2=240,Om=64,N2=45,ib=250,Um=56;function D2(n){n.computeBoundingBox();let{min:e,max:t}=n.boundingBox,i=Math.max(t.x-e.x,t.y-e.y,t.z-e.z,1e-9)/Um,s=n.getAttribute("position"),r=new Map,o=new Uint32Array(s.count);for(let c=0;c<s.count;c++){let[u,h,f]=[(s.getX(c)-e.x)/i,(s.getY(c)-e.y)/i,(s.getZ(c)-e.z)/i].map(Math.floor),d=(u*(Um+1)+h)*(Um+1)+f,y=r.get(d);y===void 0&&r.set(d,c),o[c]=y??c}let a=n.getIndex(),l=[];for(let c=0;c<a.count;c+=3){let[u,h,f]=[o[a.getX(c)],o[a.getX(c+1)],o[a.getX(c+2)]];u!==h&&h!==f&&u!==f&&l.push(u,h,f)}return new Ft(Uint32Array.from(l),1)}var df=class{constructor(e,t,i){this.canvas=e;this.pair=t;this.look=i,this.renderer=new Ts({canvas:e,antialias:!0,alpha:!1}),this.renderer.setPixelRatio(Math.min(2,window.devicePixelRatio)),this.renderer.autoClear=!1;let s=_=>{let M=new Ys(_,si,1);return M.needsUpdate=!0,M};this.maps={viridis:s(tr("viridis")),cividis:s(tr("cividis")),outlier:s(Bx())};let{frame:r}=t,o=t.target.getAttribute("position").array;t.target.setAttribute("place",Pp(r,o,()=>!0)),t.source.setAttribute("place",Pp(r,t.images,_=>t.nearest[_]>=0)),this.indices={source:{whole:t.source.getIndex()},target:{whole:t.target.getIndex()}},this.meshes={source:this.surface(t.source),target:this.surface(t.target)};let a=Math.max(1e-6,r.high.x-r.low.x),l=new br(a*.009,16,12);this.marks={source:this.marksOf(l),target:this.marksOf(l)},this.halos={source:this.halo(),target:this.halo()},this.crosses={source:this.crossOf(a),target:this.crossOf(a)};for(let _ of["source","target"])this.groups[_].add(this.meshes[_],this.marks[_],this.halos[_],this.crosses[_]),this.scene.add(this.groups[_]);this.radius=t.target.boundingSphere.radius;let c=t.source.boundingSphere.center.clone();this.centers={source:c,moved:c.clone().applyMatrix4(t.targetFromSource)},this.reach.copy(r.low).negate().max(r.high);let[u,h]=[new H,t.source.getAttribute("position")];for(let _=0;_<h.count;_++)u.fromBufferAttribute(h,_).applyMatrix4(t.targetFromSource).sub(r.center),this.reach.max(new H(...r.axes.map(M=>Math.abs(u.dot(M)))));let f=[];t.inlier.forEach((_,M)=>_&&t.nearest[M]>=0&&f.push(M));let d=Math.max(1,Math.floor(f.length/L2));this.lineRows=f.filter((_,M)=>M%d===0);let y=new jn;y.setAttribute("position",new Ft(new Float32Array(6*this.lineRows.length),3)),this.lines=new ia(y,new Yr({transparent:!0,opacity:.55,depthTest:!1})),this.lines.frustumCulled=!1,this.scene.add(this.lines),this.controls=new Ir(this.camera,e),this.controls.staticMoving=!0,this.controls.rotateSpeed=3,this.controls.zoomSpeed=1.4,this.controls.addEventListener("change",()=>this.redraw()),this.view(),this.set(i),this.sizes.observe(e);let v=0,g=0,x=_=>{this.waiting=requestAnimationFrame(x),this.controls.update();let M=_-v;v=_,this.isDirty?(_-g<1e3&&g>0&&M>N2&&(this.isSlow=!0),this.detail(!(this.isSlow&&_-g<ib)),g=_,this.draw()):!this.isWhole&&_-g>ib&&(this.detail(!0),this.draw())};x(performance.now())}canvas;pair;renderer;camera=new Li(-1,1,1,-1,-1e3,1e3);controls;scene=new es;groups={source:new bs,target:new bs};meshes;marks;halos;lines;lineRows;crosses;pose=new Je;centers;maps;reach=new H;sizes=new ResizeObserver(()=>this.resize());look;isSlow=!1;isWhole=!0;indices;waiting=0;isDirty=!0;radius;dispose(){cancelAnimationFrame(this.waiting),this.sizes.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.pair.source.dispose(),this.pair.target.dispose()}surface(e){e.setAttribute("value",new Ft(new Float32Array(e.getAttribute("position").count),1));let t=Gh(this.maps.viridis),i=new Tn(e,t);return i.matrixAutoUpdate=!1,i}detail(e){if(e!==this.isWhole){this.isWhole=e;for(let t of["source","target"]){let i=this.indices[t];i.coarse??=D2(this.pair[t]),this.pair[t].setIndex(e?i.whole:i.coarse)}}}marksOf(e){let t=new pl(e,new qs({color:16723349,depthTest:!1}),Om);return t.count=0,t.renderOrder=3,t.frustumCulled=!1,t}crossOf(e){let t=[0,1,2].flatMap(r=>[-1,1].flatMap(o=>[0,1,2].map(a=>a===r?o*e:0))),i=new jn().setAttribute("position",new Ft(Float32Array.from(t),3)),s=new ia(i,new Yr({color:16723349,depthTest:!1}));return s.renderOrder=4,s.visible=!1,s.frustumCulled=!1,s}cross(e){for(let t of["source","target"])this.crosses[t].visible=e!==null,e&&this.crosses[t].position.copy(e);this.redraw()}placeOf({side:e,vertex:t}){let i=new H().fromBufferAttribute(this.pair[e].getAttribute("position"),t);return e==="source"?i.applyMatrix4(this.pair.targetFromSource):i}halo(){let e=new Tn(new br(1,32,24),new qs({color:16723349,transparent:!0,opacity:.28,depthTest:!1}));return e.visible=!1,e.renderOrder=2,e}view(){let{center:e,axes:t}=this.pair.frame;this.controls.target.copy(e),this.camera.up.copy(t[1]),this.camera.position.copy(e).addScaledVector(t[2],4*this.radius),this.camera.near=-20*this.radius,this.camera.far=40*this.radius,this.camera.zoom=1,this.camera.lookAt(e),this.resize()}turn(e,t){let i=this.camera.position.clone().sub(this.controls.target),s=new H().crossVectors(this.camera.up,i).normalize(),r=new fn().setFromAxisAngle(this.camera.up.clone().normalize(),e);r.premultiply(new fn().setFromAxisAngle(s,t)),i.applyQuaternion(r),this.camera.up.applyQuaternion(r).normalize(),this.camera.position.copy(this.controls.target).add(i),this.camera.lookAt(this.controls.target),this.redraw()}zoom(e){this.camera.zoom=Math.min(40,Math.max(.2,this.camera.zoom*e)),this.camera.updateProjectionMatrix(),this.redraw()}set(e){let{pair:t}=this;this.look=e;let i=e.coloring==="outlier"?this.maps.outlier:this.maps[e.map];for(let r of["source","target"]){let{uniforms:o}=this.meshes[r].material;if(o.map.value=i,o.byPlace.value=e.coloring==="correspondence",o.grid.value=e.grid&&e.coloring==="correspondence",o.low.value=e.coloring==="displacement"?-e.top:0,o.top.value=e.coloring==="outlier"?1:Math.max(1e-9,e.top),e.coloring!=="correspondence"){let a=r==="source"?t.columns[e.coloring]:t.onTarget[e.coloring],l=this.meshes[r].geometry.getAttribute("value");for(let c=0;c<a.length;c++)l.array[c]=Number.isNaN(a[c])?-1e9:a[c];l.needsUpdate=!0}}let s=this.meshes.source.material;s.transparent=e.overlay&&e.opacity<1,s.depthWrite=!s.transparent,s.uniforms.opacity.value=e.overlay?e.opacity:1,this.meshes.source.renderOrder=1,this.move(),this.resize()}move(){let[e,t,i]=[new H,new fn,new H];this.pair.targetFromSource.decompose(e,t,i);let s=this.look.pose,r=new fn().slerp(t,s),o=new H(1,1,1).lerp(i,s),a=this.centers.source.clone().lerp(this.centers.moved,s),l=new Je().compose(new H,r,o);e.copy(a).sub(this.centers.source.clone().applyMatrix4(l)),this.pose.compose(e,r,o),this.meshes.source.matrix.copy(s===1?this.pair.targetFromSource:this.pose),this.pose.copy(this.meshes.source.matrix),this.meshes.source.material.uniforms.pose.value.copy(this.pose),this.redraw()}isStacked(){return this.canvas.clientWidth<1.25*this.canvas.clientHeight}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;if(e===0||t===0)return;this.renderer.setSize(e,t,!1);let i=this.look.overlay?1:2,s=this.isStacked(),[r,o]=[s?e:e/i,s?t/i:t],[a,l]=[2.2*this.reach.x,2.3*Math.max(this.reach.y,this.reach.z)];if(this.look.overlay){let u=this.centers.source.distanceTo(this.centers.moved)*(1-this.look.pose),h=2*u+(u>0?this.radius:0);[a,l]=[a+h,l+h]}let c=Math.max(a/r,l/o);this.camera.left=-e*c/2,this.camera.right=e*c/2,this.camera.top=t*c/2,this.camera.bottom=-t*c/2,this.camera.updateProjectionMatrix(),this.controls.handleResize(),this.redraw()}redraw(){this.isDirty=!0}arrange(){this.camera.updateMatrixWorld();let e=new H().setFromMatrixColumn(this.camera.matrixWorld,0),t=new H().setFromMatrixColumn(this.camera.matrixWorld,1),{source:i,target:s}=this.groups;if(i.position.set(0,0,0),s.position.set(0,0,0),!this.look.overlay){let o=this.isStacked(),a=(o?this.camera.top-this.camera.bottom:this.camera.right-this.camera.left)/this.camera.zoom/4,l=o?t.negate():e;i.position.addScaledVector(l,-a),s.position.addScaledVector(l,a);let c=this.centers.source.clone().applyMatrix4(this.pose);i.position.sub(c).add(this.centers.moved)}this.crosses.source.visible=this.crosses.target.visible&&this.look.pose===1;let r=new Wt().copy(Op);if(this.look.section!==null){let o=new H().setFromMatrixColumn(this.camera.matrixWorld,2),a=this.pair.frame.center.dot(o)+this.radius*(1-2*this.look.section);r.set(o.x,o.y,o.z,a)}for(let o of["source","target"])this.meshes[o].material.uniforms.section.value.copy(r);if(this.lines.visible=this.look.lines,this.look.lines){let o=this.lines.geometry.getAttribute("position"),[a,l]=[this.pair.source.getAttribute("position"),new H];this.lineRows.forEach((c,u)=>{l.fromBufferAttribute(a,c).applyMatrix4(this.pose).add(i.position),o.setXYZ(2*u,l.x,l.y,l.z),l.fromArray(this.pair.images,3*c).add(s.position),o.setXYZ(2*u+1,l.x,l.y,l.z)}),o.needsUpdate=!0}this.scene.updateMatrixWorld()}draw(){this.isDirty=!1;let{renderer:e,canvas:t}=this,{clientWidth:i,clientHeight:s}=t;if(i===0||s===0)return;this.arrange();let r=getComputedStyle(t);if(e.setClearColor(new rt(r.getPropertyValue("--canvas").trim()||"#f4f6f8")),this.lines.material.color.set(r.getPropertyValue("--line").trim()||"#333333"),e.setScissorTest(!1),e.clear(),this.look.overlay){e.render(this.scene,this.camera);return}let{source:o,target:a}=this.groups,l=this.lines.visible,c=this.isStacked();this.lines.visible=!1,e.setScissorTest(!0);for(let[u,h,f]of[[o,a,0],[a,o,1]])u.visible=!0,h.visible=!1,c?e.setScissor(0,f===0?s/2:0,i,s/2):e.setScissor(f*i/2,0,i/2,s),e.render(this.scene,this.camera);e.setScissorTest(!1),o.visible=a.visible=!0,l&&(o.visible=a.visible=!1,this.lines.visible=!0,e.render(this.scene,this.camera),o.visible=a.visible=!0)}pick(e,t){this.detail(!0);let{clientWidth:i,clientHeight:s}=this.canvas;this.arrange();let r=new Jr;r.setFromCamera(new Qe(2*e/i-1,1-2*t/s),this.camera);let o=["source","target"];this.look.overlay||(o=[(this.isStacked()?t>s/2:e>i/2)?"target":"source"]);let a=this.meshes.target.material.uniforms.section.value,l=(_,M)=>M.clone().sub(this.groups[_].position).dot(new H(a.x,a.y,a.z))>a.w,u=o.flatMap(_=>r.intersectObject(this.meshes[_]).map(M=>({side:_,hit:M}))).filter(({side:_,hit:M})=>!l(_,M.point)).sort((_,M)=>_.hit.distance-M.hit.distance)[0];if(u===void 0||!u.hit.face)return null;let{side:h,hit:f}=u,d=this.meshes[h].worldToLocal(f.point.clone()),y=[f.face.a,f.face.b,f.face.c],v=this.meshes[h].geometry.getAttribute("position"),g=_=>d.distanceToSquared(new H().fromBufferAttribute(v,_)),x=y.reduce((_,M)=>g(M)<g(_)?M:_);return this.describe(h,x)}describe(e,t){let{pair:i}=this;if(e==="source")return{side:e,vertex:t,others:[i.nearest[t]],spread_mm:i.columns.spread[t]};let s=[...i.sources.slice(i.starts[t],i.starts[t+1])],r=s.map(o=>i.columns.spread[o]).filter(o=>!Number.isNaN(o));return{side:e,vertex:t,others:s,spread_mm:r.length>0?Math.max(...r):NaN}}mark(e){for(let t of["source","target"])this.marks[t].count=0,this.halos[t].visible=!1;if(e!==null){let{pair:t}=this,i=(a,l)=>new H().fromBufferAttribute(t[a].getAttribute("position"),l).applyMatrix4(a==="source"?this.pose:new Je),s=(a,l)=>{l.slice(0,Om).forEach((c,u)=>this.marks[a].setMatrixAt(u,new Je().makeTranslation(c.x,c.y,c.z))),this.marks[a].count=Math.min(Om,l.length),this.marks[a].instanceMatrix.needsUpdate=!0};s(e.side,[i(e.side,e.vertex)]);let r=e.side==="source"?"target":"source",o;if(e.side==="source"?o=e.others[0]<0?[]:[new H().fromArray(t.images,3*e.vertex)]:o=e.others.map(a=>i("source",a)),s(r,o),o.length>0&&e.spread_mm>0){let a=o.reduce((l,c)=>l.add(c),new H).divideScalar(o.length);this.halos[r].position.copy(a),this.halos[r].scale.setScalar(e.spread_mm),this.halos[r].visible=!0}}this.redraw()}project(e,t){this.arrange();let{geometry:i,matrixWorld:s}=this.meshes[e],r=new H().fromBufferAttribute(i.getAttribute("position"),t).applyMatrix4(s),o=new H().fromBufferAttribute(i.getAttribute("normal"),t).transformDirection(s),a=new H().setFromMatrixColumn(this.camera.matrixWorld,2);r.project(this.camera);let{clientWidth:l,clientHeight:c}=this.canvas;return{x:(r.x+1)/2*l,y:(1-r.y)/2*c,facing:o.dot(a)}}frameTimes(e,t){this.detail(t);let i=this.renderer.getContext(),s=new Uint8Array(4);return Array.from({length:e},()=>{let r=performance.now();return this.turn(.05,.01),this.draw(),i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,s),performance.now()-r})}picture(){return this.draw(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}};var sb=[{name:"correspondence",label:"Correspondence",help:"The target is colored along its length, with a grid; each source vertex has the color and the grid of its corresponding point. Where colors jump or the grid breaks, the match is wrong.",unit:""},{name:"confidence",label:"Confidence",help:"Probability that the corresponding point is right to within one edge of the target.",unit:""},{name:"residual",label:"Residual",help:"Distance of each vertex, moved rigidly, from its corresponding point: how far the rest of the match has to bend the source.",unit:"mm"},{name:"displacement",label:"Displacement",help:"The part of it along the outward normal: the target lies inside of the source where it is negative (dark), outside where it is positive (light).",unit:"mm"},{name:"spread",label:"Spread",help:"Expected error of the corresponding point.",unit:"mm"},{name:"outlier",label:"Outliers",help:"Vertices that do not follow the transform or their neighbors, and why.",unit:""}];function F2({map:n,low:e,high:t,label:i}){let s=wt(null);return ct(()=>{s.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(tr(n)),si,1),0,0)},[n]),p("div",{class:"scale",children:[p("span",{children:e}),p("canvas",{ref:s,width:si,height:1,role:"img","aria-label":i}),p("span",{children:t})]})}function rb({job:n,pair:e,cross:t,setCross:i}){let s=wt(null),r=wt(null),[o,a]=ae(null),[l,c]=ae(null),[u,h]=ae({coloring:"correspondence",map:"viridis",top:1,grid:!0,overlay:!1,pose:1,lines:!1,section:null,opacity:.6}),f=Qt(()=>{let b=m=>Fh(e.columns[m].map(Math.abs),.95)||1;return{correspondence:1,confidence:1,outlier:1,residual:b("residual"),displacement:b("displacement"),spread:b("spread")}},[e]),d=b=>h(m=>{let w={...m,...b};return{...w,top:f[w.coloring]}});ct(()=>{let b;try{b=new df(s.current,e,u)}catch{a("This browser cannot draw in 3D (WebGL 2 is not available). The surfaces can be saved below and opened in another program.");return}return r.current=b,s.current.scene=b,()=>{b.dispose(),r.current=null}},[e]),ct(()=>r.current?.set(u),[u,e]),ct(()=>r.current?.cross(t),[t,e]);let y=xs();ct(()=>r.current?.redraw(),[y]);let v=b=>{if(b.buttons!==0)return;let m=r.current?.pick(b.offsetX,b.offsetY)??null;r.current?.mark(m),c(m)},g=wt([0,0]),x=b=>{let[m,w]=g.current;if(b.button!==0||Math.hypot(b.clientX-m,b.clientY-w)>3)return;let R=r.current?.pick(b.offsetX,b.offsetY);R&&i(r.current.placeOf(R))},_=()=>{r.current?.mark(null),c(null)},M=b=>{let w={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[b.key];if(w)r.current?.turn(...w);else if(b.key==="+"||b.key==="=")r.current?.zoom(1.2);else if(b.key==="-")r.current?.zoom(1/1.2);else if(b.key==="Home")r.current?.view();else return;b.preventDefault()},S=sb.find(({name:b})=>b===u.coloring),T=e.columns;return p("section",{class:"viewer","aria-label":"The match in 3D",children:[p("div",{class:"tools",children:[p("label",{children:["Color"," ",p("select",{value:u.coloring,onChange:b=>d({coloring:b.currentTarget.value}),children:sb.map(({name:b,label:m})=>p("option",{value:b,children:m}))})]}),p("label",{children:["Map"," ",p("select",{value:u.map,onChange:b=>d({map:b.currentTarget.value}),children:[p("option",{value:"viridis",children:"viridis"}),p("option",{value:"cividis",children:"cividis"})]})]}),p("div",{class:"choice",role:"group","aria-label":"Arrangement",children:[p("button",{"aria-pressed":!u.overlay,onClick:()=>d({overlay:!1}),children:"Side by side"}),p("button",{"aria-pressed":u.overlay,onClick:()=>d({overlay:!0}),children:"Overlaid"})]}),p("label",{class:"slider",children:["Pose: original"," ",p("input",{type:"range",min:0,max:1,step:.01,value:u.pose,"aria-label":"Pose, from original to aligned",onInput:b=>d({pose:Number(b.currentTarget.value)})})," aligned"]}),u.overlay&&p("label",{class:"slider",children:["Source"," ",p("input",{type:"range",min:.15,max:1,step:.05,value:u.opacity,"aria-label":"Opacity of the source",onInput:b=>d({opacity:Number(b.currentTarget.value)})})]}),u.coloring==="correspondence"&&p(qn,{label:"Grid",checked:u.grid,onChange:b=>d({grid:b.currentTarget.checked})}),p(qn,{label:"Inlier lines",checked:u.lines,onChange:b=>d({lines:b.currentTarget.checked})}),p(qn,{label:"Section",checked:u.section!==null,onChange:b=>d({section:b.currentTarget.checked?.4:null})}),u.section!==null&&p("input",{type:"range",min:.02,max:.98,step:.01,value:u.section,"aria-label":"Depth of the section",onInput:b=>d({section:Number(b.currentTarget.value)})}),p("span",{class:"group",children:[p("button",{onClick:()=>r.current?.view(),children:"Reset view"}),p("button",{onClick:async()=>{let b=await r.current?.picture();b&&Ha(b,`match-${n.id}.png`)},children:"Save picture"})]})]}),o!==null&&p("p",{class:"failure",children:o}),p("div",{class:"stage",children:[!u.overlay&&p(mt,{children:[p("span",{class:"caption first",children:["Source",u.pose===1?", aligned":u.pose===0?", original pose":""]}),p("span",{class:"caption second",children:"Target"})]}),p("canvas",{ref:s,id:"view",tabIndex:0,role:"img","aria-label":"Source and target surface. Arrow keys turn, plus and minus zoom, Home resets the view.",onPointerMove:v,onPointerDown:b=>g.current=[b.clientX,b.clientY],onPointerUp:x,onPointerLeave:_,onKeyDown:M}),p("output",{class:"readout","aria-live":"off",children:l===null?p("span",{class:"hint",children:"Point at a vertex to see its correspondent. Drag to turn, scroll to zoom, right button to move."}):l.side==="source"?p(mt,{children:[p("b",{children:["source vertex ",l.vertex]})," → ",l.others[0]<0?"no counterpart":`target vertex ${l.others[0]}`," · confidence ",_e(T.confidence[l.vertex],2)," · spread"," ",Mi(T.spread[l.vertex])," · residual ",Mi(T.residual[l.vertex])," · ",er[Math.floor(T.outlier[l.vertex]*er.length)]?.name]}):p(mt,{children:[p("b",{children:["target vertex ",l.vertex]})," ← ",l.others.length===0?"no source vertex has it as its nearest":`${l.others.length} source ${l.others.length===1?"vertex":"vertices"}: ${l.others.slice(0,6).join(", ")}${l.others.length>6?" …":""}`,l.spread_mm>0&&` · spread ${Mi(l.spread_mm)}`]})})]}),p("div",{class:"legend",children:[u.coloring==="outlier"?p("ul",{class:"categories",children:er.map(({name:b,color:m},w)=>{let R=T.outlier.reduce((C,I)=>C+(Math.floor(I*er.length)===w?1:0),0);return p("li",{children:[p("svg",{width:"12",height:"12","aria-hidden":"true",children:p("rect",{width:"12",height:"12",fill:kx(m)})})," ",b,": ",R.toLocaleString("en")]})})}):p(F2,{map:u.map,low:u.coloring==="correspondence"?"one end of the target":u.coloring==="displacement"?`≤ −${_e(u.top,2)} mm`:`0 ${S.unit}`,high:u.coloring==="correspondence"?"the other end":`${u.coloring==="confidence"?"":"≥ "}${_e(u.top,2)} ${S.unit}`,label:`Scale of ${It(u.coloring)}`}),p("p",{children:[S.help," Gray: no counterpart."]})]})]})}var O2=[["Correspondences, CSV","correspondences?format=csv","correspondences.csv"],["Aligned source, PLY","aligned?format=ply","aligned.ply"],["Bent source, PLY","warped?format=ply","warped.ply"],["Bent source, GIFTI","warped?format=gifti","warped.surf.gii"],["Bent source, VTP","warped?format=vtp","warped.vtp"],["Target surface, PLY","surfaces/target?format=ply","target.ply"],["Both surfaces in color, glTF","correspondences?format=glb","match.glb"],["Transform, ITK","transform?format=tfm","transform.tfm"],["Transform, FreeSurfer","transform?format=lta","transform.lta"],["Result, JSON","result","result.json"],["Report, HTML","report?format=html","report.html"]];function ob({job:n,failed:e}){return p("div",{class:"saves",children:O2.map(([t,i,s])=>p("button",{onClick:()=>bc(`v1/jobs/${n.id}/${i}`,s).catch(e),children:t}))})}function ab({id:n}){let[e,t]=ae(null),[i,s]=ae([]),[r,o]=ae(null),[a,l]=ae(null),[c,u]=ae(null),[h,f]=ae(!0),[d,y]=ae(null),v=m=>y(Et(m)),g=ki();Vt(m=>{t(null),s([]),o(null),l(null),u(null),y(null),ri(()=>vt(`v1/jobs/${n}?fields=*`,m),m).then(I=>!m.aborted&&t(E=>E??I),I=>!m.aborted&&v(I));let w=[],R=0,C=()=>{R=0;let I=w;w=[],m.aborted||s(E=>[...E,...I])};$x(n,{job:I=>t(E=>lo(E,{...I,queue_position:I.queue_position??(I.state==="queued"?E?.queue_position:void 0)})),trace:I=>{w.push(...I),R===0&&(R=window.setTimeout(C,60))},progress:I=>t(E=>E===null?E:{...E,progress:I}),connected:f,failed:v},m)},[n]);let x=e?.state==="succeeded"&&!Tm(e);Vt(m=>{!x||e===null||qx(e,m).then(w=>{m.aborted||(l(w.result),o(w.pair))},w=>!m.aborted&&v(w))},[n,x]);let _=e!==null&&!Kn(e.state),M=Qt(()=>p(nb,{points:i,isLive:_}),[i,_]);if(e===null)return d===null?p("p",{class:"loading",children:"Loading the job …"}):p(At,{text:d});let S=Og(e),T=m=>{y(null),Vn("POST",`v1/jobs/${n}/${m}`).then(w=>m==="retry"?Ti(`jobs/${w.id}`):t(R=>R?.id===w.id?lo(R,{...w,parameters:R.parameters}):R),v)},b=e.started_at?Bi((e.finished_at?Date.parse(e.finished_at):g)-Date.parse(e.started_at)):null;return p("article",{class:"job",children:[p("h1",{class:"sub",children:["Job ",p("code",{children:n})]}),p("section",{class:`verdict ${S.tone}`,"aria-label":"Verdict",children:[p("span",{class:"mark","aria-hidden":"true",children:S.mark}),p("div",{children:[p("p",{class:"title",id:"verdict",children:S.title}),S.lines.map(m=>p("p",{children:m})),p("p",{class:"next",children:[p("b",{children:"Next:"})," ",S.next]})]}),p("div",{class:"actions",children:[!Kn(e.state)&&p("button",{disabled:e.cancel_requested,onClick:()=>T("cancel"),children:"Cancel"}),Kn(e.state)&&p("button",{onClick:()=>T("retry"),children:"Retry"})]})]}),p(At,{text:d}),!Kn(e.state)&&p("p",{class:"live",role:"status",children:[p(wi,{share:e.progress?.fraction??0,label:"Progress"})," ",Po(e.progress?.fraction??0)," · ",e.progress?.message??It(e.state)," ",b!==null&&`· ${b}`,!h&&p(hn,{tone:"bad",children:"connection lost, trying again"})]}),r!==null&&p(mt,{children:[p(rb,{job:e,pair:r,cross:c,setCross:u}),p(Kv,{job:e,pair:r,cross:c,setCross:u})]}),x&&r===null&&d===null&&p("p",{class:"loading big",children:"Loading the surfaces …"}),p("div",{class:"columns",children:[e.state==="succeeded"&&Tm(e)&&p(Fv,{job:e}),a!==null&&p(U2,{result:a}),M,p("section",{class:"card",children:[p("h2",{children:"The job"}),p(Rn,{rows:[["State",p(Lo,{state:e.state})],["Method",`${e.method} ${e.method_version}`],["Source",`${_e(e.source.n_vertices)} vertices, ${e.source.report.format}`],["Target",`${_e(e.target.n_vertices)} vertices, ${e.target.report.format}`],["Priority",_e(e.priority)],["Attempt",`${e.attempt} of ${e.max_attempts}`],["Created",new Date(e.created_at).toLocaleString()],["Ran for",b??"–"],["Result from",e.cached?"an earlier, equal job":"this job"],...e.batch_id?[["Batch",p("a",{href:`#/batches/${e.batch_id}`,children:e.batch_id.slice(-8)})]]:[],...e.retry_of?[["Retry of",p("a",{href:`#/jobs/${e.retry_of}`,children:e.retry_of.slice(-8)})]]:[],...e.external_ref?[["Reference",e.external_ref]]:[],...Object.entries(e.tags).map(([m,w])=>[`Tag ${m}`,w])]})]}),a!==null&&p(B2,{result:a}),x&&p("section",{class:"card",children:[p("h2",{children:"Save"}),p(ob,{job:e,failed:v})]}),p(k2,{job:e}),p("section",{class:"card",children:[p("h2",{children:"Parameters and provenance"}),p(z2,{job:e}),a!==null&&p(Rn,{rows:[["Program",`${a.provenance.version}, commit ${a.provenance.commit}`],["Seed",_e(a.provenance.seed)],["Source file",p("code",{class:"hash",children:e.source.hash})],["Target file",p("code",{class:"hash",children:e.target.hash})]]})]})]})]})}function U2({result:n}){let{surface_distance:e,topology:t,deformation:i,support:s,reliability:r}=n,o=[["Surface distance, mean",Mi(e.mean_mm)],["Surface distance, 95 % within",Mi(e.p95_mm)],["Surface distance, largest",Mi(e.max_mm)],["Neighbors that stay neighbors",Po(t.consistency)],["Target vertices reached",Po(t.coverage)],["Inliers of the transform",`${_e(s.inliers)} (${Po(s.ratio)})`],["Rotation",`${n.transform.rotation_angle_deg.toFixed(1)}°`]];return i&&o.push(["Folded triangles",`${_e(i.folded_triangles)} (${Po(i.folded_area_share)} of the area)`],["Area, target over source (5th to 95th percentile)",`${_e(i.area_ratio)} (${_e(i.area_ratio_p05)} to ${_e(i.area_ratio_p95)})`],["Volume, target over source",_e(i.volume_ratio)]),r&&(o.push(["Misfit (about 1.0 for copies, 1.2 for two subjects)",_e(r.misfit)],["Misfit of the next best pose",_e(r.runner_up_misfit)],["Misfit of a mirrored source",_e(r.other_handedness_misfit)],["Curvature agreement",_e(r.curvature_agreement)],["Agreement of directions",_e(r.normal_agreement)]),r.second_opinion&&o.push(["Agreement with the default method (1 if equal, 0 if unrelated)",_e(r.second_opinion.agreement)],["Angle to its pose",`${r.second_opinion.angle_deg.toFixed(1)}°`]),r.distortion!==void 0&&o.push(["Distortion (0 if angles are kept, about 0.2 for two subjects)",_e(r.distortion)])),p("section",{class:"card",children:[p("h2",{children:"How good it is"}),p(Rn,{rows:o})]})}function B2({result:n}){let{total:e=1,...t}=n.timings_ms,i=Object.entries(t).sort(([,s],[,r])=>r-s);return p("section",{class:"card",children:[p("h2",{children:["Time: ",Bi(e)]}),p(Rn,{rows:i.map(([s,r])=>[It(s),p(mt,{children:[p(wi,{share:r/e,label:`Share of ${It(s)}`})," ",Bi(r)]})])})]})}function k2({job:n}){let{source:e,target:t}=n,i=(s,r)=>p("tr",{children:[p("th",{scope:"row",children:s}),p("td",{children:r(e)}),p("td",{children:r(t)})]});return p("section",{class:"card",children:[p("h2",{children:"Surfaces"}),p("table",{class:"plain",children:[p("thead",{children:p("tr",{children:[p("td",{}),p("th",{scope:"col",children:"Source"}),p("th",{scope:"col",children:"Target"})]})}),p("tbody",{children:[i("Format",s=>s.report.format),i("Vertices",s=>_e(s.n_vertices)),i("Faces",s=>_e(s.n_faces)),i("Genus",s=>String(s.report.topology.genus??"open")),i("Pieces",s=>_e(s.report.topology.n_components)),i("Boundary edges",s=>_e(s.report.topology.n_boundary_edges)),i("Area",s=>`${_e(s.report.topology.area_mm2)} mm²`),i("Volume",s=>s.report.topology.volume_mm3===null?"–":`${_e(s.report.topology.volume_mm3)} mm³`),i("Repairs",s=>s.report.repairs.length===0?"none":String(s.report.repairs.length))]})]})]})}function z2({job:n}){let[e,t]=ae(null);Vt(o=>{ri(()=>vt(`v1/methods/${n.method}`,o),o).then(a=>!o.aborted&&t(a.defaults),()=>{})},[n.method]);let i=Bm(n.parameters??{}),s=new Map(e?Bm(e):[]),r=e===null?[]:i.filter(([o,a])=>o!=="seed"&&s.get(o)!==a);return p(mt,{children:[p("p",{children:e===null?"":r.length===0?`All as the method ${n.method} sets them.`:`Different from the method ${n.method}:`}),r.length>0&&p(Rn,{rows:r.map(([o,a])=>[o,p("code",{children:a})])}),p("details",{children:[p("summary",{children:["All ",i.length," parameters"]}),p(Rn,{rows:i.map(([o,a])=>[o,p("code",{children:a})])})]})]})}function Bm(n,e=""){return n===null||typeof n!="object"||Array.isArray(n)?[[e,JSON.stringify(n)]]:Object.entries(n).flatMap(([t,i])=>Bm(i,e===""?t:`${e}.${t}`))}var V2=n=>`file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(n)?.[0]??""}`;async function pf(n,e,t){return await(await Mn(`v1/meshes?file_name=${encodeURIComponent(V2(e))}`,{method:"POST",body:n,headers:{"content-type":"application/octet-stream"},signal:t})).json()}function Dr(n){let e=n;for(;new TextEncoder().encode(e).length>256;)e=e.slice(1);return e}var mf=n=>Object.fromEntries(n.split(/[\s,]+/).filter(Boolean).map(e=>[e.slice(0,e.indexOf(":")),e.slice(e.indexOf(":")+1)])),lb=/(^|\/)\.|\.(json|txt|csv|tsv|md|log|html?|pdf|png|jpe?g|gif|svg|zip|xml|py|m|sh)$/i,cb=n=>[...n].sort((e,t)=>e.path.localeCompare(t.path,"en",{numeric:!0}));function km(n){let e=[...n].map(t=>({file:t,path:t.webkitRelativePath||t.name}));return cb(e.filter(({file:t,path:i})=>!t.webkitRelativePath||!lb.test(i)))}async function ub(n){let e=[...n?.items??[]].flatMap(s=>s.webkitGetAsEntry?.()??[]);if(e.length===0)return km(n?.files??[]);let t=[],i=async(s,r)=>{let o=s.fullPath.replace(/^\//,"");if(s.isFile){if(r&&lb.test(o))return;t.push({file:await new Promise((l,c)=>s.file(l,c)),path:o});return}let a=s.createReader();for(;;){let l=await new Promise((c,u)=>a.readEntries(c,u));if(l.length===0)return;for(let c of l)await i(c,!0)}};for(let s of e)await i(s,!1);return cb(t)}function hb(n){let e=o=>o.split("/").at(-1).split(".").find(Boolean)??o,t=n.map(e),i=n.map((o,a)=>[...o.split("/").slice(0,-1),t[a]].join("/")),r=n.every(o=>o.includes("/")&&o.split("/")[0]===n[0].split("/")[0])?i.map(o=>o.slice(o.indexOf("/")+1)):i;for(let o of[t,r,n])if(new Set(o).size===o.length)return o.map(Dr);return n.map((o,a)=>Dr(`${o} ${a+1}`))}function gf({method:n,schemas:e,changed:t,change:i,faults:s}){let r=u=>{let h=u.$ref?.split("/").at(-1),f=h===void 0?void 0:e[h];if(f)return{...r(f),description:u.description??f.description};let d=[...u.oneOf??[],...u.anyOf??[]].filter(y=>y.type!=="null");return d.length===1?{...r(d[0]),description:u.description??d[0].description,type:[String(r(d[0]).type),"null"]}:u},o=u=>u.reduce((h,f)=>h===null||typeof h!="object"?void 0:h[f],n.defaults),a=(u,h,f)=>{let d={...t,[u]:h};JSON.stringify(h)===JSON.stringify(f)&&delete d[u],i(d)},l=(u,h)=>Object.entries(r(u).properties??{}).map(([f,d])=>{let y=r(d),v=[...h,f];if(v.join()==="method")return null;if(y.properties)return p("fieldset",{children:[p("legend",{children:It(f)}),y.description&&p("p",{class:"soft",children:y.description}),l(y,v)]},f);let g=v.join("."),x=o(v),_=g in t?t[g]:x,M=s.find(({pointer:S})=>S.replace(/^\/parameters/,"")===`/${v.join("/")}`);return p(H2,{name:g,schema:y,value:_,isChanged:g in t,fault:M,set:S=>a(g,S,x)},g)}),c=Object.keys(t).length;return p("details",{children:[p("summary",{children:["Parameters",c>0&&`: ${c} changed`]}),c>0&&p("button",{onClick:()=>i({}),children:"All as the method sets them"}),p("div",{class:"fields",children:l({$ref:"PartialParameters"},[])})]})}var G2=[[/_mm$/,"mm"],[/_deg$/,"°"],[/_ms$/,"ms"],[/_s$/,"s"],[/_bytes$/,"bytes"]];function H2({name:n,schema:e,value:t,isChanged:i,fault:s,set:r}){let[o,a]=ae(null),l=[e.type??[]].flat(),c=G2.find(([v])=>v.test(n))?.[1],u=l.includes("number")||l.includes("integer"),h=e.enum??e.oneOf?.flatMap(v=>v.const??v.enum??[]),f=It(n.split(".").at(-1)),d;h&&h.length>0&&!l.includes("array")?d=p("select",{value:t===null?"null":String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value),children:[(l.includes("null")||t===null)&&p("option",{value:"null",children:"not set"}),h.map(v=>p("option",{value:String(v),children:String(v)}))]}):l.includes("boolean")?d=p("select",{value:String(t),onChange:v=>r(v.currentTarget.value==="null"?null:v.currentTarget.value==="true"),children:[(l.includes("null")||t===null)&&p("option",{value:"null",children:"not set"}),p("option",{value:"true",children:"yes"}),p("option",{value:"false",children:"no"})]}):u?d=p("input",{type:"number",step:l.includes("integer")?e.multipleOf??1:"any",min:e.minimum,max:e.maximum,placeholder:l.includes("null")?"not set":void 0,value:t==null?"":String(t),onChange:v=>r(v.currentTarget.value===""?null:Number(v.currentTarget.value))}):d=p("input",{value:o??JSON.stringify(t??null),spellcheck:!1,onInput:v=>a(v.currentTarget.value),onChange:v=>{try{r(JSON.parse(v.currentTarget.value)),a(null)}catch{}}});let y=[e.minimum!==void 0&&`at least ${_e(e.minimum)}`,e.maximum!==void 0&&`at most ${_e(e.maximum)}`].filter(Boolean).join(", ");return p("div",{class:`field ${i?"changed":""}`,children:[p("label",{children:[p("span",{children:[f," ",c&&p("span",{class:"soft",children:["(",c,")"]})]})," ",d]}),p("p",{class:"soft",children:[e.description," ",y&&`(${y})`]}),s&&p(At,{text:s.detail})]})}function _f(n){let e={};for(let[t,i]of Object.entries(n)){let s=t.split("."),r=s.pop(),o=s.reduce((a,l)=>a[l]??={},e);o[r]=i}return e}function xf(n){let[e,t]=ae([]),[i,s]=ae({});return ct(()=>{vt("v1/methods").then(({methods:r})=>t(r),r=>n(Et(r))),vt("openapi.json").then(({components:r})=>s(r.schemas),r=>n(Et(r)))},[]),{methods:e,schemas:i}}var fb=3,zm=200,La=({mesh:n,failure:e})=>e??(n?.problem?[n.problem.title,n.problem.detail].filter(Boolean).join(": "):null);function mb(){let[n,e]=ae(null),[t,i]=ae([]),[s,r]=ae("target"),[o,a]=ae("balanced"),[l,c]=ae({}),[u,h]=ae(""),[f,d]=ae(""),[y,v]=ae([]),[g,x]=ae(null),[_,M]=ae(!1),[S,T]=dr("names","no"),{methods:b,schemas:m}=xf(x),w=wt([]),R=wt(new Set),C=wt(0),I=wt(null),E=wt(0);Vt(Q=>{I.current=Q},[]);let F=(Q,ue)=>{let Me=We=>We.key===Q?{...We,...ue}:We;e(We=>We&&Me(We)),i(We=>We.map(Me))},D=async()=>{if(!(E.current>=fb)){E.current++;for(let Q=w.current.shift();Q&&!I.current?.aborted;Q=w.current.shift()){let{key:ue,file:Me}=Q;if(R.current.has(ue))try{F(ue,{mesh:await ri(()=>pf(Me,Me.name,I.current),I.current)})}catch(We){F(ue,{failure:Et(We)})}}E.current--}},z=Q=>{let ue=Q.map(Me=>({...Me,key:C.current++,mesh:null,failure:null}));ue.forEach(({key:Me})=>R.current.add(Me)),w.current.push(...ue);for(let Me=0;Me<fb;Me++)D();return ue},X=Q=>{Q[0]!==void 0&&(n&&R.current.delete(n.key),e(z([Q[0]])[0]))},k=Q=>{let ue=new Set(t.map(({path:Me})=>Me));i([...t,...z(Q.filter(({path:Me})=>!ue.has(Me)))])},se=Q=>{t.forEach(ue=>(Q===null||ue.key===Q)&&R.current.delete(ue.key)),i(Q===null?[]:t.filter(ue=>ue.key!==Q))},q=hb(t.map(({path:Q})=>Q)),J=t.filter(Q=>La(Q)!==null).length,ne=t.filter(Q=>Q.mesh!==null&&La(Q)===null),pe=t.length-J-ne.length,te=n?.mesh&&La(n)===null&&ne.length>0&&pe===0,j=async()=>{M(!0),x(null),v([]);try{let Q=await Vn("POST","v1/batches",{template:{mesh_id:n.mesh.id},template_as:s,subjects:ne.map((ue,Me)=>({input:{mesh_id:ue.mesh.id},external_ref:S==="yes"?q[t.indexOf(ue)]:`subject ${String(Me+1).padStart(3,"0")}`,tags:S==="yes"?{[s==="target"?"source_file":"target_file"]:Dr(ue.path)}:{}})),parameters:_f({method:o,...l}),tags:{...S==="yes"?{[s==="target"?"target_file":"source_file"]:Dr(n.path)}:{},...mf(f)},...u===""?{}:{external_ref:u}});Ti(`batches/${Q.id}`)}catch(Q){x(Et(Q)),Q instanceof zn&&v(Q.problem.errors??[]),M(!1)}},he=b.find(({name:Q})=>Q===o),me=t.map((Q,ue)=>({given:Q,name:q[ue]})).sort((Q,ue)=>+(La(ue.given)!==null)-+(La(Q.given)!==null));return p("div",{class:"submit",children:[p("h1",{children:"New batch"}),p("p",{children:"One template is matched with every subject. Files are checked as soon as they are here; those that cannot be matched are left out."}),p("div",{class:"pair",children:[p(pb,{title:"Template",take:X,label:"File of the template",many:!1,children:n===null?p("p",{class:"hint",children:"Drop a file here: the surface that all are compared with, such as a mean, an atlas, or one of the subjects."}):p("p",{children:[n.path," ",p(db,{given:n})]})}),p(pb,{title:"Subjects",take:k,label:"Files of the subjects",many:!0,children:[p("p",{role:"status",children:t.length===0?p("span",{class:"hint",children:"Drop a folder or many files here. Notes and pictures in a folder are passed over."}):p(mt,{children:[p(wi,{share:(t.length-pe)/t.length,label:"Files that are checked"})," ",_e(ne.length)," of ",_e(t.length)," can be matched",J>0&&`, ${_e(J)} cannot`,pe>0&&`, ${_e(pe)} are being sent`,"."," "]})}),t.length>0&&p("button",{onClick:()=>se(null),children:"Take all out"})]})]}),t.length>0&&p("div",{class:"scroll files",tabIndex:0,role:"region","aria-label":"Files of the subjects",children:p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Subject"}),p("th",{scope:"col",children:"File"}),p("th",{scope:"col",children:"State"}),p("th",{scope:"col",class:"numeric",children:"Vertices"}),p("th",{scope:"col",class:"numeric",children:"Size"}),p("th",{scope:"col",children:p("span",{class:"quiet",children:"Actions"})})]})}),p("tbody",{children:me.slice(0,zm).map(({given:Q,name:ue})=>p("tr",{children:[p("td",{children:ue}),p("td",{children:Q.path}),p("td",{class:"why",children:p(db,{given:Q})}),p("td",{class:"numeric",children:_e(Q.mesh?.n_vertices)}),p("td",{class:"numeric",children:Io(Q.file.size)}),p("td",{children:p("button",{"aria-label":`Take out ${ue}`,onClick:()=>se(Q.key),children:"Take out"})})]},Q.key))})]})}),me.length>zm&&p("p",{class:"hint",children:[_e(me.length-zm)," more."]}),p("section",{class:"card section",children:[p("h2",{children:"Method"}),p("div",{class:"tools",children:[p("label",{children:["Method"," ",p("select",{value:o,onChange:Q=>{a(Q.currentTarget.value),c({})},children:b.map(({name:Q})=>p("option",{value:Q,children:Q}))})]}),p("label",{children:["The template is"," ",p("select",{value:s,onChange:Q=>r(Q.currentTarget.value),children:[p("option",{value:"target",children:"the target, and stays"}),p("option",{value:"source",children:"the source, and is moved"})]})]}),p("label",{children:["Reference ",p("input",{value:u,onInput:Q=>h(Q.currentTarget.value)})]}),p("label",{children:["Tags ",p("input",{placeholder:"study:baseline",value:f,onInput:Q=>d(Q.currentTarget.value)})]})]}),p("p",{children:[p(qn,{label:"Name the jobs by their files",checked:S==="yes",onChange:Q=>T(Q.currentTarget.checked?"yes":"no")})," ",p("span",{class:"soft",children:"Else they are numbered, in the order of the table. Not for names that identify people: whoever may read the jobs reads them."})]}),p("p",{children:he?.description}),he&&p(gf,{method:he,schemas:m,changed:l,change:c,faults:y})]}),p(At,{text:g}),p("div",{class:"tools send",children:[p("button",{class:"primary",disabled:!te||_,onClick:()=>{j()},children:["Match ",_e(ne.length)," ",ne.length===1?"subject":"subjects"]}),!te&&p("span",{class:"hint",children:n===null?"A template is needed.":pe>0?"Files are being sent.":"A template and a subject that can be matched are needed."})]})]})}function db({given:n}){let e=La(n);return p(mt,{children:[e!==null?p(hn,{tone:"bad",children:"cannot be matched"}):n.mesh!==null?p(hn,{tone:"good",children:"✓ can be matched"}):p(hn,{tone:"wait",children:"being sent"})," ",e??""]})}function pb({title:n,label:e,many:t,take:i,children:s}){let[r,o]=ae(!1),a=(l,c)=>p("label",{class:"button",children:[l,p("input",{class:"quiet",type:"file",multiple:t,...c?{webkitdirectory:!0}:{},"aria-label":`${e}${c?", a folder":""}`,onChange:u=>{i(km(u.currentTarget.files??[])),u.currentTarget.value=""}})]});return p("section",{class:`card drop ${r?"over":""}`,"aria-label":n,onDragOver:l=>{l.preventDefault(),o(!0)},onDragLeave:()=>o(!1),onDrop:l=>{l.preventDefault(),o(!1),ub(l.dataTransfer).then(i)},children:[p("h2",{children:n}),p("p",{class:"tools",children:[a(t?"Choose files …":"Choose a file …",!1),t&&a("Choose a folder …",!0)]}),s]})}function W2(n){let e=new Map;for(let t of n.split(`
`)){let i=/^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)$/.exec(t);if(!i||t.startsWith("#"))continue;let s=Object.fromEntries([...(i[2]??"").matchAll(/(\w+)="((?:[^"\\]|\\.)*)"/g)].map(([,o,a])=>[o,a])),r=e.get(i[1])??[];r.push({labels:s,value:Number(i[3])}),e.set(i[1],r)}return e}var gb=(n,e)=>(n.get(e)??[]).reduce((t,{value:i})=>t+i,0),_b=500;function xb(){let[n,e]=ae(null),[t,i]=ae([]),[s,r]=ae([]),[o,a]=ae([]),[l,c]=ae(null),[u,h]=ae(null),f=ki();if(Vt(R=>{(async()=>{for(let C=0;!R.aborted;C++){try{let I=W2(await(await Mn("metrics",{signal:R})).text()),E=F=>I.get("homolog_jobs")?.find(({labels:D})=>D.state===F)?.value??0;e(I),i(F=>[...F.slice(-299),{at:Date.now(),finished:gb(I,"homolog_jobs_finished_total"),queued:E("queued"),running:E("running")}]),r((await vt("v1/jobs?state=running&page_size=100",R)).jobs),vt("readyz",R).then(({dependencies:F})=>c(F),F=>c(F instanceof zn?F.problem.dependencies??{}:null)),C%10===0&&a(await $2(R)),h(null)}catch(I){R.aborted||h(Et(I))}await Jn(2e3,R)}})()},[]),n===null)return u===null?p("p",{class:"loading",children:"Loading …"}):p(At,{text:u});let d=R=>n.get(R)?.[0]?.value??0,y=R=>gb(n,R),v=(R,C)=>(n.get(R)??[]).map(({labels:I,value:E})=>[I[C]??Object.values(I).join(" "),E]).filter(([,I])=>I>0),g=t.at(-1),x=d("homolog_queue_oldest_age_seconds"),_=d("homolog_job_store_up")===1,M=Object.entries(l??{}).filter(([,R])=>R!=="ok"),S=R=>n.get("homolog_workers")?.find(({labels:C})=>C.state===R)?.value??0,T=g.queued>0&&g.running===0&&x>30,b=!_||M.length>0||T?"bad":x>600?"wait":"good",m=new Map;for(let R of s){let C=R.worker??"unnamed worker";m.set(C,[...m.get(C)??[],R])}let w=t[0].at;return p("div",{children:[p("h1",{children:"Operations"}),p("section",{class:`verdict ${b}`,"aria-label":"Verdict",children:[p("span",{class:"mark","aria-hidden":"true",children:b==="good"?"✓":b==="bad"?"✕":"…"}),p("div",{children:[p("p",{class:"title",children:b==="good"?"The queue is healthy":T?"Nothing runs":b==="wait"?"Jobs wait long":"A dependency fails"}),p("p",{children:[_e(g.queued)," queued, ",_e(g.running)," running",g.queued>0&&`; the oldest has waited ${Bi(x*1e3)}`,"."]}),p("p",{class:"next",children:[p("b",{children:"Next:"})," ",b==="good"?"nothing to do.":T?S("idle")===0?"No worker runs: start one, and look into the log of those that ended.":"Workers are idle: look whether a job asks for more memory than one of them has.":b==="wait"?"Add workers, or lower the priority of what can wait.":`Look at ${M.map(([R,C])=>`${R} (${C})`).join(", ")||"the database"}.`]})]})]}),p(At,{text:u}),p("div",{class:"columns",children:[p("section",{class:"card wide",children:[p("h2",{children:"Queue, since this page was opened"}),p(Ia,{title:`Queued ${g.queued}, running ${g.running}`,x:t.map(({at:R})=>(R-w)/1e3),series:[{label:"queued",color:"#2f7ebc",values:t.map(({queued:R})=>R),width:2},{label:"running",color:"#d55e00",values:t.map(({running:R})=>R),width:2}],height:220,xLabel:"seconds",yLabel:"jobs",whole:!0})]}),p("section",{class:"card",children:[p("h2",{children:"Workers and what they run"}),p("p",{id:"use",children:[p("b",{children:[_e(S("busy"))," ",S("busy")===1?"worker runs":"workers run"," ",_e(g.running)," ",g.running===1?"job":"jobs"]}),", ",_e(S("idle"))," ",S("idle")===1?"is":"are"," idle",g.queued>0&&`, ${_e(g.queued)} ${g.queued===1?"job waits":"jobs wait"}`,"."]}),p(Rn,{rows:[["Processes for computations, at work or at rest",_e(y("homolog_children_started_total")-y("homolog_children_ended_total"))],["Jobs finished here since this page was opened",_e(y("homolog_jobs_finished_total")-t[0].finished)]]}),p("p",{class:"soft",children:"A worker is a process, of all tenants; below are those that run jobs of this key's tenant."}),[...m].map(([R,C])=>p("div",{children:[p("h3",{children:[p("code",{children:R}),": ",C.length," ",C.length===1?"job":"jobs"]}),p("ul",{class:"running",children:C.map(I=>p("li",{children:[p("a",{href:`#/jobs/${I.id}`,children:["…",Qn(I.id)]})," ",I.method,", ",It(I.progress?.phase??"starting"),", ",I.started_at?_s(I.started_at,f):""," ",p(wi,{share:I.progress?.fraction??0,label:`Progress of ${Qn(I.id)}`})]}))})]},R))]}),p("section",{class:"card",children:[p("h2",{children:"Failures by kind"}),o.length===0?p("p",{class:"hint",children:"No job of this tenant has failed."}):p(Rn,{rows:o.map(([R,C,I])=>[R,p(mt,{children:[_e(C),", newest ",p("a",{href:`#/jobs/${I}`,children:["…",Qn(I)]})]})])}),p("p",{class:"soft",children:["Among the last ",_b," jobs of this tenant that failed or were given up."]})]}),p("section",{class:"card",children:[p("h2",{children:"Finished since the service was started"}),p(Rn,{rows:v("homolog_jobs_finished_total","state").map(([R,C])=>[R,_e(C)])}),p(Rn,{rows:v("homolog_problems_total","type").map(([R,C])=>[`Refused: ${It(R).replaceAll("-"," ")}`,_e(C)])})]}),p("section",{class:"card",children:[p("h2",{children:"This process"}),p(Rn,{rows:[...Object.entries(l??{}).map(([R,C])=>[It(R),p(hn,{tone:C==="ok"?"good":"bad",children:C})]),["Memory",Io(d("process_resident_memory_bytes"))],["Running since",d("process_start_time_seconds")?new Date(1e3*d("process_start_time_seconds")).toLocaleString():"–"],["Leases of lost workers",_e(d("homolog_leases_expired_total"))],["Jobs given up",_e(d("homolog_jobs_dead_total"))]]})]})]})]})}async function $2(n){let e=await Promise.all(["failed","dead"].map(i=>vt(`v1/jobs${Si({state:i,page_size:_b})}`,n))),t=new Map;for(let i of e.flatMap(({jobs:s})=>s)){let s=i.error?.title??"Crashed too often",[r,o]=t.get(s)??[0,i.id];t.set(s,[r+1,o>i.id?o:i.id])}return[...t].map(([i,[s,r]])=>[i,s,r]).sort(([,i],[,s])=>s-i)}var X2={queued:"wait",matching:"wait",modelling:"wait",finished:"good",failed:"bad",cancelled:"neutral"},Vm=({state:n})=>p(hn,{tone:X2[n],children:n==="modelling"?"modeling":n}),yf=n=>n==="finished"||n==="failed"||n==="cancelled";function Gm({state:n,progress:e}){let{template_round:t,matches_done:i,matches_total:s}=e;return n==="queued"?"waits for a worker":n==="modelling"?"computes the shape model and the statistics":n==="matching"?`${t>0?`makes the template, round ${t}`:"matches the subjects"}: ${_e(i)} of ${_e(s)}`:n}function yb(){let[n,e]=ae([]),[t,i]=ae(),[s,r]=ae(null),[o,a]=ae(!1),l=ki(),c=async(u,h)=>{try{let f=await vt(`v1/studies${Si({page_size:50,page_token:u})}`,h);e(d=>u===void 0?f.studies:[...d,...f.studies]),i(f.next_page_token),r(null),a(!0)}catch(f){h?.aborted||r(Et(f))}};return Vt(u=>{(async()=>{for(await c(void 0,u);!u.aborted;)await Jn(3e3,u),!u.aborted&&!document.hidden&&scrollY<200&&await c(void 0,u)})()},[]),p("div",{children:[p("h1",{children:"Studies"}),p(At,{text:s}),o&&n.length===0&&p("p",{class:"empty",children:["There is no study yet. ",p("code",{children:"POST /v1/studies"})," or ",p("code",{children:"homolog study"})," begins one; ",p("a",{href:"docs/",children:"the API"})," says how."]}),n.length>0&&p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Studies",children:p("table",{children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Study"}),p("th",{scope:"col",children:"State"}),p("th",{scope:"col",children:"Progress"}),p("th",{scope:"col",class:"numeric",children:"Subjects"}),p("th",{scope:"col",children:"Method"}),p("th",{scope:"col",children:"Tags"}),p("th",{scope:"col",children:"Age"})]})}),p("tbody",{children:n.map(u=>p("tr",{children:[p("td",{children:p("a",{href:`#/studies/${u.id}`,children:u.external_ref??`…${Qn(u.id)}`})}),p("td",{children:p(Vm,{state:u.state})}),p("td",{children:[u.state==="matching"&&p(wi,{share:u.progress.matches_done/Math.max(1,u.progress.matches_total),label:`Progress of ${u.external_ref??Qn(u.id)}`}),!yf(u.state)&&p("span",{class:"soft",children:Gm(u)}),u.error&&p("span",{class:"soft",children:u.error.title})]}),p("td",{class:"numeric",children:_e(u.n_subjects)}),p("td",{children:u.method}),p("td",{children:Object.entries(u.tags).map(([h,f])=>`${h}:${f}`).join(", ")}),p("td",{children:_s(u.created_at,l)})]},u.id))})]})}),t!==void 0&&p("button",{onClick:()=>{c(t)},children:"More"})]})}function vb(n){let e=[[]],[t,i]=["",!1],s=()=>{e.at(-1).push(/^'[=+\-@\t\r\n]/.test(t)?t.slice(1):t),t=""};for(let a=0;a<n.length;a++){let l=n[a];i?l!=='"'?t+=l:n[a+1]==='"'?t+=n[++a]:i=!1:l==='"'?i=!0:l===","?s():l===`
`?(s(),e.push([])):l!=="\r"&&(t+=l)}(t!==""||e.at(-1).length>0)&&s();let[r=[],...o]=e;return o.filter(a=>a.length>0).map(a=>Object.fromEntries(r.map((l,c)=>[l,a[c]??""])))}function Hm({map:n,title:e,ticks:t}){let i=wt(null);return ct(()=>{i.current?.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(tr(n)),si,1),0,0)},[n]),p("figure",{class:"colorbar",children:[p("figcaption",{children:e}),p("canvas",{ref:i,width:si,height:1,role:"img","aria-label":`Color bar of ${e}, from ${t[0]} to ${t.at(-1)}`}),p("div",{class:"ticks","aria-hidden":"true",children:t.map(s=>p("span",{children:s},s))})]})}function go(n){let e=new DataView(n),t=0,i=()=>{let l="";for(;t<e.byteLength;){let c=e.getUint8(t++);if(c===10)break;l+=String.fromCharCode(c)}return l},s=()=>{for(;;){let l=i().trim();if(l!==""||t>=e.byteLength)return l.split(" ")}},r=(l,c)=>{let u={double:8,vtktypeint64:8,float:4,int:4,unsigned_char:1}[c??""];if(u===void 0||t+l*u>e.byteLength)throw new Error("This VTK file cannot be read.");let h=d=>{let y=t+d*u;return c==="double"?e.getFloat64(y):c==="float"?e.getFloat32(y):c==="vtktypeint64"?Number(e.getBigInt64(y)):c==="int"?e.getInt32(y):e.getUint8(y)},f=Float64Array.from({length:l},(d,y)=>h(y));return t+=l*u,f},o=new jn,a={};for(let l=0;l<4;l++)i();for(;t<e.byteLength;){let[l,c,u]=s();if(l==="POINTS")o.setAttribute("position",new Ft(Float32Array.from(r(3*Number(c),u)),3));else if(l==="POLYGONS"){let h=r(Number(c),s()[1]),f=r(Number(u),s()[1]),d=[];for(let y=0;y+1<h.length;y++)for(let v=h[y]+1;v+1<h[y+1];v++)d.push(f[h[y]],f[v],f[v+1]);o.setIndex(new Ft(Uint32Array.from(d),1))}else if(l==="FIELD")for(let h=0;h<Number(u);h++){let[f,d,y,v]=s();a[f]=Float32Array.from(r(Number(d)*Number(y),v))}}return o.computeVertexNormals(),o.computeBoundingSphere(),{geometry:o,arrays:a}}function Mb({geometry:n,coloring:e,positions:t,label:i,id:s,file:r,readout:o}){let a=wt(null),l=wt(null),[c,u]=ae(null),[h,f]=ae(null),d=xs();ct(()=>{try{l.current=new Hh(a.current,n.clone())}catch{u("This browser cannot draw in 3D (WebGL 2 is not available). The maps are in the archive.");return}return a.current.scene=l.current,()=>{l.current?.dispose(),l.current=null}},[n]),ct(()=>{e&&l.current?.color(e)},[n,e]),ct(()=>{t&&l.current?.move(t)},[n,t]),ct(()=>l.current?.redraw(),[d]);let y=g=>{g.buttons===0&&f(l.current?.pick(g.offsetX,g.offsetY)??null)},v=g=>{let _={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.12],ArrowDown:[0,.12]}[g.key];if(_)l.current?.turn(..._);else if(g.key==="+"||g.key==="=")l.current?.zoom(1.2);else if(g.key==="-")l.current?.zoom(1/1.2);else if(g.key==="Home")l.current?.view();else return;g.preventDefault()};return p(mt,{children:[p(At,{text:c}),p("div",{class:"stage half",children:p("canvas",{ref:a,id:s,tabIndex:0,role:"img","aria-label":`${i}. Arrow keys turn, plus and minus zoom, Home resets the view.`,onPointerMove:y,onPointerLeave:()=>f(null),onKeyDown:v})}),p("output",{class:"readout","aria-live":"off",children:h===null?p("span",{class:"hint",children:"Point at a vertex for its values. Drag to turn, scroll to zoom."}):o(h)}),p("div",{class:"tools",children:[p("button",{onClick:()=>l.current?.view(),children:"Reset view"}),p("button",{onClick:async()=>{let g=await l.current?.picture();g&&Ha(g,r)},children:"Save picture"})]})]})}var bb={normal_displacement:{title:"normal displacement",unit:"mm"},log_area:{title:"logarithm of area",unit:"ln"},thickness:{title:"thickness",unit:"mm"}},q2=[{name:"effect",title:"effect",kind:"effect"},{name:"hedges_g",title:"Hedges' g",kind:"signed"},{name:"t",title:"t",kind:"signed"},{name:"z",title:"z",kind:"signed"},{name:"p_local",title:"p, local (TFCE and false discovery rate)",kind:"p"},{name:"p_tfce_fwe",title:"p, corrected (TFCE, family-wise)",kind:"p"},{name:"p_permutation",title:"p, uncorrected (permutations)",kind:"p"},{name:"p",title:"p, uncorrected",kind:"p"},{name:"q_fdr",title:"q (false discovery rate)",kind:"p"}],Sb=3,wb=n=>[-1,-.5,0,.5,1].map(e=>e===0?"0":`${e===-1?"≤ ":e===1?"≥ ":""}${e<0?"−":""}${_e(Math.abs(e)*n,2)}`),Tb=n=>Fh(n.map(Math.abs),.99)||1e-6;function Ab({archive:n,result:e,name:t}){let i=e.found.maps.filter(({measure:E,contrast:F})=>n.has(`maps/${E}.${F}.vtk`)),s=[...new Set(i.map(({contrast:E})=>E))],[r,o]=ae(s[0]??""),[a,l]=ae(i[0]?.measure??""),[c,u]=ae("effect"),[h,f]=ae(!1),[d,y]=ae(null),[v,g]=ae(null),x=`maps/${a}.${r}.vtk`;Vt(E=>{n.has(x)&&n.bytes(x).then(F=>{if(E.aborted)return;let{geometry:D,arrays:z}=go(F);y(X=>({file:x,geometry:X?.geometry??D,arrays:z}))},F=>!E.aborted&&g(Et(F)))},[n,x]);let _=d?.arrays,M=q2.filter(({name:E})=>_===void 0||E in _),S=M.find(({name:E})=>E===c)??M[0],T=_?.p_local??_?.p_tfce_fwe??_?.q_fdr,{title:b,unit:m}=bb[a]??{title:It(a),unit:""},w=Qt(()=>{let E=_?.[S.name];if(E===void 0)return null;let F=z=>!h||T===void 0||T[z]<.05;if(S.kind==="p")return{coloring:{values:E.map((X,k)=>F(k)?-Math.log10(Math.max(X,10**-Sb)):NaN),low:0,high:Sb,map:"viridis"},ticks:["1","0.1","0.01","≤ 0.001"],map:"viridis"};let D=Tb(E);return{coloring:{values:E.map((z,X)=>F(X)?z:NaN),low:-D,high:D,map:"blue_red"},ticks:wb(D),map:"blue_red"}},[_,S.name,h]);if(i.length===0)return p("p",{class:"hint",children:"No effect was asked for, so there are no maps."});let R=i.find(E=>E.measure===a&&E.contrast===r),C=S.kind==="effect"?`effect on ${b}${m==="mm"?", mm":m==="ln"?", natural logarithm":""}`:`${S.title} of ${b}`,I=_&&T?T.filter(E=>E<.05).length:null;return p(mt,{children:[p("div",{class:"tools",children:[p("label",{children:["Contrast"," ",p("select",{value:r,onChange:E=>o(E.currentTarget.value),children:s.map(E=>p("option",{value:E,children:E}))})]}),p("label",{children:["Measure"," ",p("select",{value:a,onChange:E=>l(E.currentTarget.value),children:i.filter(E=>E.contrast===r).map(E=>p("option",{value:E.measure,children:bb[E.measure]?.title??It(E.measure)}))})]}),p("label",{children:["Color by"," ",p("select",{value:S.name,onChange:E=>u(E.currentTarget.value),children:M.map(({name:E,title:F})=>p("option",{value:E,children:F}))})]}),p(qn,{label:"Only local p < 0.05",checked:h,onChange:E=>f(E.currentTarget.checked)})]}),p(At,{text:v}),d===null?p("p",{class:"loading big",children:"Loading the map …"}):p(Mb,{geometry:d.geometry,coloring:w?.coloring??null,id:"map",label:`The mean surface, colored by ${C}, contrast ${r}`,file:`${t}-${a}-${r}-${S.name}.png`,readout:E=>`vertex ${E} · ${M.map(({name:F,title:D,kind:z})=>`${D.split(" (")[0]} ${_e(_?.[F]?.[E])}${z==="effect"&&m==="mm"?" mm":""}`).join(" · ")}`}),p("div",{class:"legend",children:[w&&p(Hm,{map:w.map,title:C,ticks:w.ticks}),p("p",{id:"map-says",children:[R&&`Smallest corrected p ${_e(R.smallest_p,2)}; ${_e(100*R.significant_share,2)} % of the surface significant${I===null?"":` (${_e(I)} vertices)`}.`,S.kind!=="p"&&" Red: above zero; blue: below."," ",h&&"Gray: local p not below 0.05."]})]})]})}var _o=2;function Eb({archive:n,result:e,name:t}){let{compactness:i}=e.found.model,s=v=>100*(i[v-1]-(i[v-2]??0)),r=i.map((v,g)=>g+1).filter(v=>n.has(`modes/mode-${v}-plus-2sd.vtk`)),[o,a]=ae(r[0]??1),[l,c]=ae(_o),[u,h]=ae(null),[f,d]=ae(null);Vt(v=>{r.length!==0&&Promise.all(["minus","plus"].map(g=>n.bytes(`modes/mode-${o}-${g}-2sd.vtk`))).then(([g,x])=>{if(v.aborted)return;let[_,M]=[go(g).geometry,go(x).geometry],[S,T]=[_,M].map(w=>w.getAttribute("position").array),b=S.map((w,R)=>(w+T[R])/2),m=S.map((w,R)=>(T[R]-w)/(2*_o));h(w=>w?{...w,step:m}:(_.getAttribute("position").array.set(b),_.computeVertexNormals(),_.computeBoundingSphere(),{geometry:_,mean:b,normals:Float32Array.from(_.getAttribute("normal").array),step:m}))},g=>!v.aborted&&d(Et(g)))},[n,o]);let y=Qt(()=>{if(u===null)return null;let{mean:v,normals:g,step:x}=u,_=Float32Array.from({length:v.length/3},(T,b)=>new H().fromArray(x,3*b).dot(new H().fromArray(g,3*b))),M=_o*Tb(_);return{coloring:{values:_.map(T=>l*T),low:-M,high:M,map:"blue_red"},top:M,positions:v.map((T,b)=>T+l*x[b])}},[u,l]);return r.length===0?p("p",{class:"hint",children:"The model has no modes."}):p(mt,{children:[p("div",{class:"tools",children:[p("label",{children:["Mode"," ",p("select",{value:String(o),onChange:v=>a(Number(v.currentTarget.value)),children:r.map(v=>p("option",{value:String(v),children:[v,": ",_e(s(v))," % of the variance"]}))})]}),p("label",{class:"slider",children:["−",_o," SD"," ",p("input",{type:"range",min:-_o,max:_o,step:.1,value:l,"aria-label":"Standard deviations along the mode","aria-valuetext":`${l.toFixed(1)} standard deviations`,onInput:v=>c(Number(v.currentTarget.value))})," +",_o," SD"]}),p("button",{onClick:()=>c(0),children:"Mean"})]}),p(At,{text:f}),u===null?p("p",{class:"loading big",children:"Loading the mode …"}):p(Mb,{geometry:u.geometry,coloring:y.coloring,positions:y.positions,id:"mode",label:`The mean shape, moved by ${l.toFixed(1)} standard deviations along mode ${o}`,file:`${t}-mode-${o}-${l.toFixed(1)}sd.png`,readout:v=>`vertex ${v} · ${_e(y.coloring.values[v])} mm along the normal of the mean`}),p("div",{class:"legend",children:[y&&p(Hm,{map:"blue_red",title:"displacement along the normal of the mean, mm",ticks:wb(y.top)}),p("p",{children:["The mean ",l===0?"itself":`and ${l>0?"+":"−"}${Math.abs(l).toFixed(1)} standard deviations`," along mode ",o,", which explains ",_e(s(o))," % of the variance. Red: outwards; blue: inwards."]})]})]})}var Y2={model:{text:"in the model",tone:"good"},scored:{text:"compared with the model",tone:"good"},unreliable:{text:"left out: match not reliable",tone:"bad"},dropped:{text:"excluded by decision",tone:"neutral"},failed:{text:"no match",tone:"bad"}};function j2({flags:n="",reasons:e="",error:t=""}){let i=n.split("; ").filter(Boolean),s=[It(e).replaceAll(";",","),t].filter(Boolean).join(", ");return i.map((r,o)=>o===0&&s!==""?`${r} (${s})`:r).join(", ")||s}var Wm=100;function Cb({study:n,rows:e,matches:t,deciding:i,picture:s,version:r,top:o}){let[a,l]=ae(null),[c,u]=ae(Wm),[h,f]=ae(!1),d=new Map((n.subjects??[]).map(g=>[g.id,g])),y=e??(n.subjects??[]).map(({id:g})=>({id:g})),v=y.filter(g=>!h||g.flags||d.get(g.id)?.decision);return y.length===0?null:p("section",{"aria-label":"Quality control",class:"section",children:[p("h2",{children:"Quality control"}),p("div",{class:"tools",children:[p("span",{class:"hint",children:e===null?"The subjects and their matches.":`The most urgent first. Pictures: the template deformed onto the subject; red lies outside of the mean (${_e(o,2)} mm or more), blue inside.`}),e!==null&&p("label",{class:"check",children:[p("input",{type:"checkbox",checked:h,onChange:g=>f(g.currentTarget.checked)})," Only those to look at, or decided"]})]}),p("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Subjects",children:p("table",{class:"quality",children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"Subject"}),e!==null&&p(mt,{children:[p("th",{scope:"col",children:"Shape"}),p("th",{scope:"col",children:"Place"}),p("th",{scope:"col",children:"Look at"}),p("th",{scope:"col",class:"numeric",children:"Residual, mm"}),p("th",{scope:"col",class:"numeric",children:"Turned over, %"}),p("th",{scope:"col",class:"numeric",children:"Unusual, p"})]}),p("th",{scope:"col",children:"Match"}),p("th",{scope:"col",children:"Decision"})]})}),p("tbody",{children:v.slice(0,c).map(g=>{let x=g.id,_=t.get(x),M=Y2[g.place??""],S=d.get(x)??{decision:g.decision||void 0,reason:g.reason},T=g.place!=="failed";return p("tr",{"data-subject":x,"data-place":g.place,children:[p("th",{scope:"row",children:x}),e!==null&&p(mt,{children:[p("td",{children:s&&T&&p(Wh,{name:`${r}/${x}`,alt:`Shape of ${x}`,load:()=>s(x)})}),p("td",{children:M&&p(hn,{tone:M.tone,children:M.text})}),p("td",{class:"why",children:j2(g)}),p("td",{class:"numeric",children:T?Number(g.residual_mm).toFixed(3):""}),p("td",{class:"numeric",children:T?(100*Number(g.folded)).toFixed(2):""}),p("td",{class:"numeric",children:g.mahalanobis_p?_e(Number(g.mahalanobis_p),2):""})]}),p("td",{children:_&&p("a",{href:`#/jobs/${_.id}`,children:_.state})}),p("td",{class:"decision",children:a===x?p(J2,{subject:x,cancel:()=>l(null),decide:async(b,m)=>{await i.decide(x,b,m),l(null)}}):S?.decision?p(mt,{children:[p(hn,{tone:S.decision==="kept"?"good":"neutral",children:S.decision==="kept"?"keep":"exclude"})," ",S.reason," ",p("button",{"aria-label":`Take back the decision about ${x}`,onClick:()=>{i.undo(x).catch(()=>{})},children:"Take back"})]}):p("button",{"aria-label":`Decide about ${x}`,onClick:()=>l(x),children:"Decide …"})})]},x)})})]})}),v.length===0&&p("p",{class:"empty",children:"Nobody is to be looked at."}),v.length>c&&p("button",{onClick:()=>u(c+Wm),children:["Further ",_e(Math.min(Wm,v.length-c))," of ",_e(v.length)]})]})}function J2({subject:n,decide:e,cancel:t}){let[i,s]=ae("dropped"),[r,o]=ae(""),[a,l]=ae(!1),c=wt(null);Ng(()=>c.current?.focus(),[]);let u=async h=>{h.preventDefault(),l(!0),await e(i,r.trim()).catch(()=>l(!1))};return p("form",{class:"tools","aria-label":`Decision about ${n}`,onSubmit:u,onKeyDown:h=>h.key==="Escape"&&t(),children:[p("select",{"aria-label":"Decision",value:i,ref:c,onChange:h=>s(h.currentTarget.value),children:[p("option",{value:"dropped",children:"exclude"}),p("option",{value:"kept",children:"keep"})]}),p("input",{"aria-label":"Reason",placeholder:"reason",required:!0,value:r,onInput:h=>o(h.currentTarget.value)}),p("button",{class:"primary",type:"submit",disabled:a,children:"Save"}),p("button",{type:"button",onClick:t,children:"Cancel"})]})}var Z2=65536,K2=286,[Q2,e3,t3,n3,i3]=[101010256,101075792,117853008,33639248,67324752],nc=()=>new zn({type:"about:blank",title:"The archive of the study cannot be read",status:502}),vf=class n{constructor(e,t,i,s,r){this.path=e;this.etag=t;this.total=i;this.entries=s;this.signal=r}path;etag;total;entries;signal;static async open(e,t){let i=await Mn(e,{headers:{range:`bytes=-${Z2}`},cache:"no-store",signal:t}),s=new DataView(await i.arrayBuffer()),r=i.headers.get("etag")??"",o=Number(/\/(\d+)$/.exec(i.headers.get("content-range")??"")?.[1]??s.byteLength),a=o-s.byteLength,l=s.byteLength-22;for(;l>=0&&s.getUint32(l,!0)!==Q2;)l--;if(l<0)throw nc();let[c,u,h]=[s.getUint16(l+10,!0),s.getUint32(l+12,!0),s.getUint32(l+16,!0)];if(l>=20&&s.getUint32(l-20,!0)===t3){let v=Number(s.getBigUint64(l-12,!0))-a;if(v<0||s.getUint32(v,!0)!==e3)throw nc();[c,u,h]=[v+32,v+40,v+48].map(g=>Number(s.getBigUint64(g,!0)))}let f=new n(e,r,o,new Map,t),d=h>=a?new DataView(s.buffer,h-a,u):new DataView(await f.part(h,u)),y=0;for(let v=0;v<c;v++){if(d.getUint32(y,!0)!==n3)throw nc();let[g,x,_]=[28,30,32].map(m=>d.getUint16(y+m,!0)),M=new TextDecoder().decode(new Uint8Array(d.buffer,d.byteOffset+y+46,g)),[S,T]=[d.getUint32(y+20,!0),d.getUint32(y+42,!0)],b=d.getUint32(y+24,!0);for(let m=y+46+g;m+4<=y+46+g+x;){let[w,R]=[d.getUint16(m,!0),d.getUint16(m+2,!0)],C=m+4,I=()=>Number(d.getBigUint64((C+=8)-8,!0));w===1&&(b===4294967295&&I(),S===4294967295&&(S=I()),T===4294967295&&(T=I())),m+=4+R}f.entries.set(M,{offset:T,size:S,nameLength:g,method:d.getUint16(y+10,!0)}),y+=46+g+x+_}return f}has(e){return this.entries.has(e)}names(){return[...this.entries.keys()]}async bytes(e){let t=this.entries.get(e);if(t===void 0||t.method!==0)throw nc();let i=await this.part(t.offset,K2+t.nameLength+t.size),s=new DataView(i);if(s.getUint32(0,!0)!==i3)throw nc();let r=30+s.getUint16(26,!0)+s.getUint16(28,!0);return i.slice(r,r+t.size)}async text(e){return new TextDecoder().decode(await this.bytes(e))}async part(e,t){let i=Math.min(this.total,e+t)-1,s=await Mn(this.path,{headers:{range:`bytes=${e}-${i}`,"if-range":this.etag},cache:"no-store",signal:this.signal}),r=await s.arrayBuffer();if(s.status===206)return r;if(s.headers.get("etag")!==this.etag)throw new zn({type:"about:blank",title:"The study was computed again: open it anew",status:409});return r.slice(e,i+1)}};async function s3(n,e){let t=new Map,i="";for(;i!==void 0;){let s=await vt(`v1/jobs${Si({study:n,order:"asc",fields:"id,state,external_ref",page_size:500,page_token:i})}`,e);for(let r of s.jobs)r.external_ref&&t.set(r.external_ref,r);i=s.next_page_token}return t}function Rb({id:n}){let[e,t]=ae(null),[i,s]=ae(new Map),[r,o]=ae(null),[a,l]=ae(null),[c,u]=ae(0),h=_=>l(Et(_)),f=ki();Vt(_=>{(async()=>{try{for(;;){let M=await ri(()=>vt(`v1/studies/${n}`,_),_);if(t(M),s(await ri(()=>s3(n,_),_)),yf(M.state))break;await Jn(Math.max(2e3,4*M.n_subjects),_),_.throwIfAborted()}}catch(M){_.aborted||h(M)}})()},[n,c]);let d=e?.state==="finished"?`${n}/${e.finished_at}`:null;if(Vt(_=>{d!==null&&(async()=>{try{let[M,S]=await Promise.all([ri(()=>vf.open(`v1/studies/${n}/archive`),_),ri(()=>vt(`v1/studies/${n}/result`,_),_)]),[T,b]=[vb(await M.text("quality.csv")),go(await M.bytes("mean.vtk"))];_.aborted||o({archive:M,result:S,mean:b,rows:T,version:d})}catch(M){_.aborted||h(M)}})()},[d]),e===null)return a===null?p("p",{class:"loading",children:"Loading the study …"}):p(At,{text:a});let y=_=>(l(null),_.then(M=>{t(S=>({...S,...M})),u(S=>S+1)},M=>{throw h(M),M})),v=_=>`v1/studies/${n}/subjects/${encodeURIComponent(_)}/decision`,g={decide:(_,M,S)=>y(Vn("PUT",v(_),{decision:M,reason:S})),undo:_=>y(Vn("DELETE",v(_)))},x=e.external_ref??n.slice(-8);return p("article",{class:"study",children:[p("h1",{class:"sub",children:["Study ",e.external_ref??p("code",{children:n})," ",p(Vm,{state:e.state})]}),p(a3,{study:e,found:r,cancel:()=>{y(Vn("POST",`v1/studies/${n}/cancel`)).catch(()=>{})}}),p(At,{text:a}),p("div",{class:"columns",children:[p(l3,{study:e,matches:i,hasResult:r!==null}),p("section",{class:"card",children:[p("h2",{children:"The study"}),p(Rn,{rows:[["Subjects",_e(e.n_subjects)],["Method of the matches",e.method],...r3(r?.result),["Created",`${new Date(e.created_at).toLocaleString()}, ${_s(e.created_at,f)} ago`],...e.finished_at?[["Finished",new Date(e.finished_at).toLocaleString()]]:[],...Object.entries(e.tags).map(([_,M])=>[`Tag ${_}`,M])]})]}),e.state==="finished"&&p("section",{class:"card",children:[p("h2",{children:"Report and files"}),p("div",{class:"saves",children:[p("button",{onClick:()=>Wf(`v1/studies/${n}/report`,!0).catch(h),children:"Open the report"}),p("button",{onClick:()=>Wf(`v1/studies/${n}/archive`,!1).catch(h),children:"Save the archive, ZIP"}),p("button",{onClick:()=>bc(`v1/studies/${n}/result`,`study-${x}.json`).catch(h),children:"Save the result, JSON"})]}),p("p",{class:"soft",children:"The report is one page to print; the archive has all tables, surfaces, maps, modes and labels."})]})]}),p(Cb,{study:e,rows:r?.rows??null,matches:i,deciding:g,top:r?Pb(r.result):0,picture:r&&(async _=>d===r.version?o3(r,_):null),version:r?.version??n}),r!==null&&p(mt,{children:[p("section",{class:"card section","aria-label":"Maps",children:[p("h2",{children:"Maps on the mean surface"}),p(Ab,{archive:r.archive,result:r.result,name:`study-${x}`},r.version)]}),p("section",{class:"card section","aria-label":"Modes",children:[p("h2",{children:"Modes of the shape model"}),p(Eb,{archive:r.archive,result:r.result,name:`study-${x}`},r.version)]})]})]})}function r3(n){let e=n?.settings.analysis;return e?[["Effect",e.effect??"none asked for"],...e.adjust?.length?[["Adjusted for",e.adjust.join(", ")]]:[],...e.effect&&e.permutations?[["Permutations",_e(e.permutations)]]:[]]:[]}var Pb=({found:n})=>2*Math.sqrt(n.model.variances_mm2.reduce((e,t)=>e+t,0))||1;async function o3({archive:n,mean:e,result:t},i){let s=`subjects/${i}.vtk`;if(!n.has(s))return null;let{geometry:r,arrays:o}=go(await n.bytes(s)),a=o.normal_displacement,l=Pb(t);return{geometry:r,frame:jx(r,e.geometry),coloring:a&&{values:a,low:-l,high:l,map:"blue_red"}}}function a3({study:n,found:e,cancel:t}){let i=n.state==="finished",s=(e?.rows??[]).filter(h=>h.flags!==""&&h.decision==="").length,r=e?.result.found.subjects,o=r&&[`${_e(r.model)} in the shape model`,...r.scored?[`${_e(r.scored)} compared with it`]:[],...r.unreliable?[`${_e(r.unreliable)} left out: match not reliable`]:[],...r.dropped?[`${_e(r.dropped)} excluded by decision`]:[],...r.failed?[`${_e(r.failed)} without a match`]:[]],a=n.state==="failed"||i&&s>0?"bad":i?"good":n.state==="cancelled"?"neutral":"wait",l=Gm(n),c=i?e===null?"Finished":s>0?`${_e(s)} of ${_e(n.n_subjects)} to look at`:"No subject stands out":l[0].toUpperCase()+l.slice(1),u=i?s>0?"Look at the subjects at the head of the table; exclude those that are wrong, and keep those that are right.":"Look at the maps, then open the report.":n.state==="failed"?"Correct what is said above, or add subjects, and submit it again.":n.state==="cancelled"?"Submit it again; matches that are finished are not computed twice.":"Quality control, maps and modes appear here when it is finished.";return p("section",{class:`verdict ${a}`,"aria-label":"Verdict",children:[p("span",{class:"mark","aria-hidden":"true",children:{good:"✓",bad:"✕",neutral:"–",wait:"…"}[a]}),p("div",{role:"status",children:[p("p",{class:"title",id:"verdict",children:c}),i&&o&&p("p",{children:[o.join(", "),"."]}),n.error&&p("p",{children:[n.error.title,n.error.detail].filter(Boolean).join(": ")}),p("p",{class:"next",children:[p("b",{children:"Next:"})," ",u]})]}),p("div",{class:"actions",children:!yf(n.state)&&p("button",{onClick:t,children:"Cancel"})})]})}function l3({study:n,matches:e,hasResult:t}){let{state:i,progress:s}=n,r=i==="finished"?3:i==="modelling"?2:i==="matching"&&s.template_round===0?1:0,o=i==="failed"||i==="cancelled",a=u=>o?t?"done":"not reached":u<r?"done":u===r?"now":"to come",l=[[s.template_round>0?`Template, round ${s.template_round}`:"Template",a(0)],["Matches with all subjects",a(1)],["Shape model, statistics and report",a(2)]],c=new Map;for(let{state:u}of e.values())c.set(u,(c.get(u)??0)+1);return p("section",{class:"card",children:[p("h2",{children:"Steps and matches"}),p("ol",{class:"steps",children:l.map(([u,h])=>p("li",{class:h.replace(" ","-"),"aria-current":h==="now"?"step":void 0,children:[u,": ",p("b",{children:h})]}))}),i==="matching"&&p("p",{children:[p(wi,{share:s.matches_done/Math.max(1,s.matches_total),label:"Matches that are finished"})," ",_e(s.matches_done)," of ",_e(s.matches_total)]}),p("p",{id:"matches",children:[[...c].map(([u,h])=>`${_e(h)} ${It(u)}`).join(", ")||"No match yet",". ",p("a",{href:`#/jobs?study=${n.id}`,children:"All matches"})]})]})}function Ib({ply:n,fault:e,name:t}){let i=wt(null),s=xs(),[r,o]=ae(null);return ct(()=>{let a=i.current,l;try{l=new Ts({canvas:a,antialias:!0})}catch{o("This browser cannot draw in 3D.");return}let{geometry:c}=ya(n),u=Cs(c),h=c.boundingSphere?.radius||1,f=new es,d=new Tn(c,new yl({color:9417945,side:mi}));f.add(d,new Ml(16777215,8952234,1.4));let y=new Tl(16777215,1.6);if(f.add(y),e){let C=(I,E)=>{let F=new Tn(new br(h*I,24,16),new qs({color:14024812,transparent:!0,opacity:E,depthTest:!1}));F.position.set(...e),F.renderOrder=1,f.add(F)};C(.03,1),C(.1,.35)}l.setPixelRatio(Math.min(2,devicePixelRatio));let v=new Li(-1,1,1,-1,-20*h,40*h),[g,x,_]=u.axes;v.up.copy(x);let M=e&&new H(...e).sub(u.center).dot(_)<0?-4:4;v.position.copy(u.center).addScaledVector(_,M*h).addScaledVector(g,1e-4),v.lookAt(u.center);let S=new Ir(v,a);S.target.copy(u.center),S.staticMoving=!0,S.rotateSpeed=3;let T=!0;S.addEventListener("change",()=>T=!0);let b=()=>{let{clientWidth:C,clientHeight:I}=a;if(C===0)return;l.setSize(C,I,!1);let E=Math.max(1.1*Math.max(-u.low.x,u.high.x)/C,1.2*Math.max(-u.low.y,u.high.y)/I)||h/I;[v.left,v.right,v.top,v.bottom]=[-E*C,E*C,E*I,-E*I],v.updateProjectionMatrix(),S.handleResize(),T=!0},m=new ResizeObserver(b);m.observe(a);let w=0,R=()=>{w=requestAnimationFrame(R),S.update(),T&&(T=!1,y.position.copy(v.position).sub(u.center),l.setClearColor(new rt(getComputedStyle(a).getPropertyValue("--canvas").trim()||"#f4f6f8")),l.render(f,v))};return b(),R(),()=>{cancelAnimationFrame(w),m.disconnect(),S.dispose(),c.dispose(),l.dispose()}},[n,e?.join(),s]),r===null?p("canvas",{class:"preview",ref:i,role:"img","aria-label":`The ${t} surface${e?", the place of the fault is marked":""}`}):p("p",{class:"failure",children:r})}var Lb=["source","target"],c3=128<<20;function Nb(){let[n,e]=ae({source:null,target:null}),[t,i]=ae("balanced"),[s,r]=ae({}),[o,a]=ae(0),[l,c]=ae(""),[u,h]=ae(""),[f,d]=ae([]),[y,v]=ae(null),[g,x]=ae(null),[_,M]=ae(!1),[S,T]=dr("names","no"),{methods:b,schemas:m}=xf(v),w=(k,se)=>e(q=>({...q,[k]:{...q[k]??{name:"",mesh:null,ply:null,failure:null},...se}})),R=async(k,se,q)=>{x(null),w(k,{name:q,mesh:null,ply:null,failure:null});try{let J=await pf(se,q);if(w(k,{mesh:J}),J.n_bytes>c3)return;let ne=await Mn(`v1/meshes/${J.id}/surface`).catch(()=>null);ne&&w(k,{ply:await ne.arrayBuffer()})}catch(J){w(k,{failure:Et(J)})}},C=(k,se)=>{if(se.length<2)return se.forEach(pe=>{R(k,pe,pe.name)});let[q,J]=[...se].sort((pe,te)=>pe.name.localeCompare(te.name)),ne=/target|fixed|reference/i.test(q.name)||/source|moving/i.test(J.name);R("source",ne?J:q,(ne?J:q).name),R("target",ne?q:J,(ne?q:J).name)},I=()=>Lb.forEach(k=>{let se=`${k}.nii.gz`;fetch(vc(`phantoms/${se}`)).then(async q=>{R(k,await q.blob(),se)},q=>w(k,{failure:Et(q)}))}),{source:E,target:F}=n,D=!!(E?.mesh&&F?.mesh),z=async k=>{M(!0),v(null),d([]),x(null);try{let se={source:{mesh_id:E.mesh.id},target:{mesh_id:F.mesh.id},parameters:_f({method:t,...s}),priority:o,tags:{...S==="yes"?{source_file:Dr(E.name),target_file:Dr(F.name)}:{},...mf(u)},...l===""?{}:{external_ref:l}},q=await Vn("POST",`v1/jobs${k?"?validate_only=true":""}`,se);k?v(""):Ti(`jobs/${q.id}`)}catch(se){if(v(Et(se)),se instanceof zn){let{errors:q,input:J,detail:ne,title:pe,place_mm:te}=se.problem;d(q??[]),(J==="source"||J==="target")&&x({side:J,text:ne??pe,place:te??null})}}finally{M(!1)}},X=b.find(({name:k})=>k===t);return p("div",{class:"submit",children:[p("h1",{children:"Submit a pair"}),p("p",{class:"tools",children:[p("span",{children:"The source is moved and deformed onto the target, which stays."}),p("button",{onClick:I,children:"Take the two built-in phantoms"})]}),p("div",{class:"pair",children:Lb.map(k=>p(u3,{side:k,given:n[k],refusal:g?.side===k?g:null,take:se=>C(k,se)},k))}),p("section",{class:"card",children:[p("h2",{children:"Method"}),p("div",{class:"tools",children:[p("label",{children:["Method"," ",p("select",{value:t,onChange:k=>{i(k.currentTarget.value),r({})},children:b.map(({name:k})=>p("option",{value:k,children:k}))})]}),p("label",{children:["Priority ",p("input",{type:"number",min:-100,max:100,value:o,onInput:k=>a(Number(k.currentTarget.value))})]}),p("label",{children:["Reference ",p("input",{value:l,onInput:k=>c(k.currentTarget.value)})]}),p("label",{children:["Tags ",p("input",{placeholder:"study:baseline",value:u,onInput:k=>h(k.currentTarget.value)})]})]}),p("p",{children:[p(qn,{label:"Keep the names of the files with the job",checked:S==="yes",onChange:k=>T(k.currentTarget.checked?"yes":"no")})," ",p("span",{class:"soft",children:"They tell jobs apart in the list. Not for names that identify people: whoever may read the job reads them."})]}),p("p",{children:X?.description}),X&&p(gf,{method:X,schemas:m,changed:s,change:r,faults:f})]}),y===""?p("p",{class:"success",role:"status",children:"These files and parameters are accepted."}):p(At,{text:y}),p("div",{class:"tools send",children:[p("button",{class:"primary",disabled:!D||_,onClick:()=>{z(!1)},children:"Match them"}),p("button",{disabled:!D||_,onClick:()=>{z(!0)},children:"Only check"}),!D&&p("span",{class:"hint",children:"Both surfaces are needed."})]})]})}function u3({side:n,given:e,refusal:t,take:i}){let[s,r]=ae(!1),o=e?.mesh,a=o?.report?.topology??o?.problem?.topology,l=t?.place??o?.problem?.place_mm??null,c=t?.text??(o?.problem?o.problem.detail??o.problem.title:null);return p("section",{class:`card drop ${s?"over":""}`,"aria-label":n,onDragOver:u=>{u.preventDefault(),r(!0)},onDragLeave:()=>r(!1),onDrop:u=>{u.preventDefault(),r(!1),i([...u.dataTransfer?.files??[]])},children:[p("h2",{children:n==="source"?"Source":"Target"}),p("p",{class:"tools file",children:[e!==null&&p("span",{children:`${e.name}${o?`, ${Io(o.n_bytes)}`:""}`}),p("label",{class:"button",children:[e===null?"Choose a file …":"Another file …",p("input",{class:"quiet",type:"file","aria-label":`File of the ${n}`,onChange:u=>i([...u.currentTarget.files??[]])})]}),e===null&&p("span",{class:"hint",children:"or drop one here."})]}),e===null&&p("p",{class:"hint",children:"Surfaces: GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3. Label volumes: NIfTI, MGZ, NRRD, MetaImage, DICOM SEG."}),e!==null&&o===null&&e.failure===null&&p("p",{class:"loading",children:"Sending and checking …"}),p(At,{text:e?.failure??null}),c&&p("p",{class:"failure",role:"alert",children:[p("b",{children:"With default parameters it is refused:"})," ",c,l&&". The place is marked."]}),o&&!c&&p("p",{class:"success",role:"status",children:"✓ It can be matched."}),e?.ply&&p(Ib,{ply:e.ply,fault:l,name:n}),a&&p(Rn,{rows:[["Format",o?.report?.format??"–"],["Vertices",_e(a.n_vertices)],["Faces",_e(a.n_faces)],["Pieces",_e(a.n_components)],["Genus",a.genus===null?"open":_e(a.genus)],["Boundary edges",_e(a.n_boundary_edges)],["Edges with more than two faces",_e(a.n_nonmanifold_edges)],["Area",`${_e(a.area_mm2)} mm²`],["Volume",a.volume_mm3===null?"–":`${_e(a.volume_mm3)} mm³`],["Repairs",o?.report?.repairs.length?String(o.report.repairs.length):"none"]]})]})}var Db=[["jobs","Jobs"],["submit","Submit"],["batches","Batches"],["studies","Studies"],["operations","Operations"]],Fb="homolog-theme";function h3(){let[n,e]=ae(localStorage.getItem(Fb)??"auto");return ct(()=>{n==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n,localStorage.setItem(Fb,n),window.dispatchEvent(new Event("theme"))},[n]),[n,e]}function f3({done:n}){let[e,t]=ae(""),[i,s]=ae(null);return p("form",{class:"card key",onSubmit:async o=>{o.preventDefault(),zr.set(e.trim());try{await vt("v1/jobs?page_size=1"),n()}catch(a){zr.set(null),s(Et(a))}},children:[p("h1",{children:"This service asks for a key"}),p("p",{children:["Paste an API key of your tenant. It is kept for this tab only, until you close it. Whoever operates the service creates keys with ",p("code",{children:"homolog keys create"}),"."]}),p("label",{children:["API key ",p("input",{type:"password",autocomplete:"off",spellcheck:!1,value:e,onInput:o=>t(o.currentTarget.value),required:!0})]}),p(At,{text:i}),p("button",{class:"primary",type:"submit",children:"Open"})]})}function d3(){let{path:n,query:e}=Bg(),[t,i]=ae(!1),[s,r]=ae(""),[o,a]=h3();ct(()=>Fg(()=>i(!0)),[]),ct(()=>{vt("healthz").then(({version:h})=>r(h),()=>{})},[]);let[l="jobs",c]=n;ct(()=>{let h=Db.find(([f])=>f===l)?.[1]??"Dashboard";document.title=c==="new"?"New batch · homolog":c?`${{batches:"Batch",studies:"Study"}[l]??"Job"} ${c.slice(-8)} · homolog`:`${h} · homolog`},[l,c]);let u;return t?u=p(f3,{done:()=>i(!1)}):l==="jobs"&&c!==void 0?u=p(ab,{id:c},c):l==="jobs"?u=p(ny,{query:e}):l==="submit"?u=p(Nb,{}):l==="batches"&&c==="new"?u=p(mb,{}):l==="batches"&&c!==void 0?u=p(Dv,{id:c},c):l==="batches"?u=p(Nv,{}):l==="studies"&&c!==void 0?u=p(Rb,{id:c},c):l==="studies"?u=p(yb,{}):l==="operations"?u=p(xb,{}):u=p("p",{class:"failure",children:"There is no view of this name. Choose one above."}),p(mt,{children:[p("a",{class:"skip",href:"#main",onClick:h=>(h.preventDefault(),document.getElementById("main")?.focus()),children:"Skip to the content"}),p("header",{children:[p("a",{class:"name",href:"#/jobs",children:"homolog"}),p("nav",{"aria-label":"Views",children:Db.map(([h,f])=>p("a",{href:`#/${h}`,"aria-current":h===l?"page":void 0,children:f}))}),p("span",{class:"end",children:[p("label",{children:[p("span",{class:"quiet",children:"Theme"})," ",p("select",{value:o,onChange:h=>a(h.currentTarget.value),children:[p("option",{value:"auto",children:"auto"}),p("option",{value:"light",children:"light"}),p("option",{value:"dark",children:"dark"})]})]}),zr.get()!==null&&p("button",{onClick:()=>{zr.set(null),i(!0)},children:"Forget key"})]})]}),p("main",{id:"main",tabIndex:-1,children:u}),p("footer",{children:["homolog ",s," · ",p("a",{href:new URL("docs/",document.baseURI.split("#")[0]).href,children:"API"})," · ",p("a",{href:new URL("assets/licenses.txt",document.baseURI.split("#")[0]).href,children:"licenses"})]})]})}Sg(p(d3,{}),document.getElementById("app"));
